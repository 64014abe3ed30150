// Walks down the distances of a border vertex, face by face.
#include "query/path_hops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <vector>

namespace vorogeo {

namespace {

/// A face on the way and how it was come to: across an edge, or around a vertex.
struct Passed {
  Index face;
  Index exit;   ///< half-edge of the face before; no_index: around `pivot`
  Index entry;  ///< half-edge of this face
  Index pivot;
};

/// Where to go from a point of a face: across an edge at a position, or to a vertex.
struct Move {
  double length = unreachable;
  Index face = no_index;
  Index vertex = no_index;
  Index halfedge = no_index;
  double x = 0.0;  ///< from the first vertex of the edge
  double edge_length = 0.0;
  double at_first = unreachable;  ///< distance of the edge's first vertex
  double at_second = unreachable;
  Index first = no_index;  ///< that vertex
  Index second = no_index;
};

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// Walks from vertex to vertex of one patch.
class HopWalker {
 public:
  explicit HopWalker(const IndexData& data)
      : data_(data), mesh_(*data.work.mesh), geometry_(*data.geometry) {}

  /// From `start` to the border vertex `goal` of a patch; along edges from where the distances lead out of
  /// the patch, or if there is no patch. \return false if no edges lead there.
  bool walk(Index patch, Index start, Index goal) {
    passed.clear();
    patch_ = patch;
    row_ = patch == no_index ? no_index : row_in_patch(data_, patch, goal);
    Index vertex = start;
    while (vertex != goal) {
      if (row_ == no_index) return walk_along_edges(vertex, goal);
      const std::size_t before = passed.size();
      const Index next = walk_to_vertex(vertex);
      if (next == no_index) {
        passed.resize(before);
        return walk_along_edges(vertex, goal);
      }
      vertex = next;
    }
    return true;
  }

  std::vector<Passed> passed;

 private:
  /// Straight on from a vertex until the next one is met; no_index if the way is longer than it should be.
  Index walk_to_vertex(Index vertex) {
    constexpr double longer = 1.1;
    at_last_ = distance(vertex);
    Move move = leave_vertex(vertex);
    double expected = at_last_ * longer;
    if (move.face == no_index || move.length > expected) return no_index;
    passed.push_back({move.face, no_index, no_index, vertex});
    std::size_t left = 4 * static_cast<std::size_t>(data_.second.member_count(patch_)) + 64;
    while (move.vertex == no_index) {
      const Index exit = move.halfedge;
      const Index entry = mesh_.next_around_edge(exit);
      expected = std::min(expected, move.length * longer);
      move = cross(entry, move);
      if (move.face == no_index || move.length > expected || --left == 0) return no_index;
      passed.push_back({Mesh::face_of(entry), exit, entry, no_index});
    }
    return move.vertex;
  }

  /// The shortest way over edges (Hart, Nilsson, Raphael 1968); such a way is short and seldom needed.
  bool walk_along_edges(Index start, Index goal) {
    struct Entry {
      double key;
      Index vertex;
      bool operator<(const Entry& other) const { return key > other.key; }
    };
    struct Reached {
      Index vertex;
      double distance;
      Index before;
      Index face;
    };
    const Point& end = mesh_.position(goal);
    auto straight = [&](Index v) {
      const Point& p = mesh_.position(v);
      return std::hypot(p[0] - end[0], p[1] - end[1], p[2] - end[2]);
    };
    std::vector<Reached> reached{{start, 0.0, no_index, no_index}};  // few, so that searching them is fast
    auto find = [&](Index v) { return std::ranges::find(reached, v, &Reached::vertex); };
    std::priority_queue<Entry> queue;
    queue.push({straight(start), start});
    while (!queue.empty()) {
      const auto [key, vertex] = queue.top();
      queue.pop();
      if (vertex == goal) break;
      const double at = find(vertex)->distance;
      if (key > (at + straight(vertex)) * (1.0 + 1e-12)) continue;
      for (Index corner : mesh_.corners(vertex)) {
        for (Index side : {corner, Mesh::previous_in_face(corner)}) {
          const Index other = side == corner ? mesh_.head(side) : mesh_.tail(side);
          const double there = at + mesh_.edge_length(mesh_.edge_of(side));
          const auto known = find(other);
          if (known == reached.end()) {
            reached.push_back({other, there, vertex, Mesh::face_of(side)});
          } else if (known->distance <= there) {
            continue;
          } else {
            *known = {other, there, vertex, Mesh::face_of(side)};
          }
          queue.push({there + straight(other), other});
        }
      }
    }
    if (find(goal) == reached.end()) return false;
    const std::size_t first = passed.size();
    for (Index v = goal; v != start;) {
      const Reached& last = *find(v);
      passed.push_back({last.face, no_index, no_index, last.before});
      v = last.before;
    }
    std::reverse(passed.begin() + static_cast<std::ptrdiff_t>(first), passed.end());
    return true;
  }

  double distance(Index vertex) const {
    const Index column = column_in_patch(data_, patch_, vertex);
    return column == no_index ? unreachable : data_.second.distance(patch_, row_, column);
  }

  /// The way from a point (px, py >= 0) across an edge on the x axis to the point beyond that has the
  /// distances at_0 and at_length from the ends of the edge.
  static void through_edge(double px, double py, double length, double at_0, double at_length, Index halfedge,
                           Move& best) {
    if (!(at_0 < unreachable && at_length < unreachable && length > 0.0)) return;
    const double difference = at_0 - at_length;
    if (std::abs(difference) > length) return;
    const double x = 0.5 * (length + difference * (at_0 + at_length) / length);
    const double y = std::sqrt(std::max(0.0, (at_0 - x) * (at_0 + x)));
    if (!(y + py > 0.0)) return;
    const double crossing = px + (x - px) * (py / (y + py));
    if (!(crossing > 0.0 && crossing < length)) return;
    const double way = length_of(x - px, y + py);
    if (way < best.length) {
      best = {way, Mesh::face_of(halfedge), no_index, halfedge, crossing, length, at_0, at_length};
    }
  }
  /// Only to vertices nearer to the goal than the last one, so that rounding of the tables makes no circles.
  void to_vertex(double step, double from_there, Index face, Index vertex, Move& best) const {
    if (from_there < at_last_ && step + from_there < best.length) {
      best = {step + from_there, face, vertex};
    }
  }

  Move leave_vertex(Index vertex) const {
    Move best;
    // Neighbours follow one another in the fan: each is the end of two of the edges opposite.
    std::array<Index, 2> known{no_index, no_index};
    std::array<double, 2> at{unreachable, unreachable};
    for (Index corner : mesh_.corners(vertex)) {
      const Index opposite = Mesh::next_in_face(corner);
      const Index face = Mesh::face_of(corner);
      const FaceFrame& frame = geometry_.frame[opposite];
      std::array<Index, 2> ends{mesh_.tail(opposite), mesh_.head(opposite)};
      if (!frame.along) std::swap(ends[0], ends[1]);
      std::array<double, 2> there{};
      for (int i = 0; i < 2; ++i) {
        const bool is_known = ends[i] == known[0] || ends[i] == known[1];
        there[i] = is_known ? at[ends[i] == known[0] ? 0 : 1] : distance(ends[i]);
        if (is_known) continue;
        const Index side = mesh_.head(corner) == ends[i] ? corner : Mesh::previous_in_face(corner);
        to_vertex(mesh_.edge_length(mesh_.edge_of(side)), there[i], face, ends[i], best);
      }
      known = ends;
      at = there;
      if (mesh_.next_around_edge(opposite) == opposite) continue;
      through_edge(frame.apex_x, frame.apex_depth, mesh_.edge_length(mesh_.edge_of(opposite)), there[0],
                   there[1], opposite, best);
      if (best.halfedge == opposite) {
        best.first = ends[0];
        best.second = ends[1];
      }
    }
    return best;
  }

  /// From the point where the last move came to the edge of a half-edge across its face. The ends of the edge
  /// and their distances come with the move, and lengths from the frame: what is read from elsewhere is far
  /// away in memory.
  Move cross(Index halfedge, const Move& last) const {
    const double x = last.x;
    const FaceFrame& frame = geometry_.frame[halfedge];
    const double length = last.edge_length;
    const double at_apex = distance(frame.apex);
    const Index face = Mesh::face_of(halfedge);
    Move best;
    to_vertex(length_of(frame.apex_x - x, frame.apex_depth), at_apex, face, frame.apex, best);
    to_vertex(x, last.at_first, face, last.first, best);
    to_vertex(length - x, last.at_second, face, last.second, best);
    for (const bool first : {true, false}) {
      const Index side = first ? frame.first_side(halfedge) : frame.second_side(halfedge);
      // The point seen from the side, whose x axis begins at the vertex it shares with the crossed edge.
      const double from_shared = first ? x : length - x;
      const double along = first ? frame.apex_x : length - frame.apex_x;
      const double side_length = length_of(along, frame.apex_depth);
      if (!(side_length > 0.0) || mesh_.next_around_edge(side) == side) continue;
      const double cosine = along / side_length;
      const double sine = frame.apex_depth / side_length;
      Move move;
      through_edge(from_shared * cosine, from_shared * sine, side_length,
                   first ? last.at_first : last.at_second, at_apex, side, move);
      if (!(move.length < best.length)) continue;
      move.first = first ? last.first : last.second;
      move.second = frame.apex;
      if (first ? frame.first_side_reversed : frame.second_side_reversed) {
        move.x = side_length - move.x;
        std::swap(move.first, move.second);
        std::swap(move.at_first, move.at_second);
      }
      best = move;
    }
    return best;
  }

  const IndexData& data_;
  const Mesh& mesh_;
  const ExactGeometry& geometry_;
  Index patch_ = no_index;
  Index row_ = no_index;
  double at_last_ = unreachable;  ///< distance of the vertex last passed
};

bool append(const Mesh& mesh, FaceStrip& strip, Index face, Index exit, Index entry, Index pivot) {
  if (exit == no_index) return turn_around(mesh, strip, pivot, face);
  strip.push(face, exit, entry);
  return true;
}

}  // namespace

bool strip_along_chain(const IndexData& data, const PathChain& chain, FaceStrip& strip) {
  const Mesh& mesh = *data.work.mesh;
  strip.clear();
  auto any_face = [&](const SurfacePoint& point) {
    return point.is_vertex() ? Mesh::face_of(mesh.corners(point.vertex).front()) : point.face;
  };
  HopWalker walker(data);
  Index vertex = chain.source;
  if (!strip.source.is_vertex()) strip.faces.push_back(strip.source.face);
  for (const ChainStep& step : chain.steps) {
    const bool forwards = step.patch == no_index || row_in_patch(data, step.patch, step.vertex) != no_index;
    if (!walker.walk(step.patch, forwards ? vertex : step.vertex, forwards ? step.vertex : vertex))
      return false;
    const auto& passed = walker.passed;
    for (std::size_t i = 0; i < passed.size(); ++i) {
      const std::size_t at = forwards ? i : passed.size() - 1 - i;
      Index exit = passed[at].exit;
      Index entry = passed[at].entry;
      Index pivot = passed[at].pivot;
      if (!forwards) {
        // The link to the face walked after this one, the other way round.
        const bool first = at + 1 == passed.size();
        exit = first ? no_index : passed[at + 1].entry;
        entry = first ? no_index : passed[at + 1].exit;
        pivot = first ? vertex : passed[at + 1].pivot;
      }
      if (strip.faces.empty()) {
        strip.faces.push_back(passed[at].face);
      } else if (!append(mesh, strip, passed[at].face, exit, entry, pivot)) {
        return false;
      }
    }
    vertex = step.vertex;
  }
  if (strip.faces.empty()) strip.faces.push_back(any_face(strip.source));
  if (strip.target.is_vertex()) {
    const auto& last = mesh.face_vertices(strip.faces.back());
    if (std::find(last.begin(), last.end(), strip.target.vertex) == last.end()) return false;
  } else if (!turn_around(mesh, strip, vertex, strip.target.face)) {
    return false;
  }
  tidy(mesh, strip);
  return true;
}

}  // namespace vorogeo
