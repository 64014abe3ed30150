// The ends of paths, and the strips of faces along edges and along routes.
#include "query/path_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <coroutine>
#include <queue>
#include <ranges>
#include <unordered_map>
#include <utility>
#include <vector>

#include "index/index_data.h"
#include "index/local_tables.h"
#include "mesh/surface_point.h"
#include "support/processor.h"
#include "support/progress.h"

namespace vorogeo {

// ---- A* search with the straight line, shortened by what a metric may save, as lower bound

double path_along_edges(const Mesh& mesh, Index start, Index goal, std::vector<PassedFace>& passed) {
  struct Entry {
    double key;
    Index vertex;
    bool operator<(const Entry& other) const { return key > other.key; }
  };
  struct Reached {
    double distance;
    Index side;  ///< half-edge on the last edge
    Index from;  ///< vertex that this edge leaves
  };
  const Point& end = mesh.position(goal);
  auto straight = [&](Index v) { return mesh.straight_bound(mesh.position(v), end); };
  std::unordered_map<Index, Reached> reached{{start, {0.0, no_index, no_index}}};
  std::priority_queue<Entry> queue;
  queue.push({straight(start), start});
  std::size_t looked_at = 0;
  // This loop ends: a vertex enters the queue again only with a smaller distance, which is the length of
  // another path.
  while (!queue.empty()) {
    const auto [key, vertex] = queue.top();
    queue.pop();
    if (vertex == goal) break;
    if (++looked_at % 256 == 0) checkpoint();
    const double at = reached.at(vertex).distance;
    if (key > (at + straight(vertex)) * (1.0 + 1e-12)) continue;
    mesh.for_each_side_at(vertex, [&](Index side, Index other) {
      const Reached found{at + mesh.edge_length(mesh.edge_of(side)), side, vertex};
      const auto [known, is_new] = reached.try_emplace(other, found);
      if (!is_new) {
        if (known->second.distance <= found.distance) return;
        known->second = found;
      }
      queue.push({found.distance + straight(other), other});
    });
  }
  if (!reached.contains(goal)) return unreachable;
  const auto first = static_cast<std::ptrdiff_t>(passed.size());
  for (Index v = goal; v != start; v = passed.back().pivot) {
    const Reached& at = reached.at(v);
    passed.push_back({Mesh::face_of(at.side), no_index, no_index, at.from});
  }
  std::reverse(passed.begin() + first, passed.end());
  return reached.at(goal).distance;
}

// ---- Patches and border distances of end points

PathEnd::PathEnd(const Mesh& mesh, const SurfacePoint& at) : point(at), vertex(at.vertex) {
  if (point.is_vertex()) return;
  const auto distances = distances_in_face(mesh, point);
  const auto nearest = std::ranges::min_element(distances);
  to_vertex = *nearest;
  vertex = mesh.face_vertices(point.face)[nearest - distances.begin()];
}

IndexedEnd::IndexedEnd(const IndexData& data, const SurfacePoint& user)
    : PathEnd(*data.surface.mesh, data.surface.inner_point(user)), place(point.vertex) {
  for_each_face_at(*data.surface.mesh, point, [&](Index face, const std::array<double, 3>&) {
    const Index at_face = data.surface.second_layer[face];
    if (std::ranges::find(patches, at_face) == patches.end()) patches.push_back(at_face);
  });
  if (point.is_vertex()) return;
  patch = patches.front();
  piece.emplace(data.surface, point.face, point.barycentric);
  const auto distances = distances_in_triangle(piece->length, piece->weights);
  const auto nearest = std::ranges::min_element(distances);
  to_place = *nearest;
  place = piece->place[nearest - distances.begin()];
}

bool are_near(const IndexData& data, const IndexedEnd& a, const IndexedEnd& b) {
  return std::ranges::any_of(a.patches, [&](Index p) {
    return std::ranges::any_of(b.patches, [&](Index q) { return p == q || data.second.touch(p, q); });
  });
}

RouteEnd route_end_of(const IndexData& data, const IndexedEnd& end) {
  RouteEnd result;
  if (!end.piece) {
    route_end(data, end.place, result);
    return result;
  }
  result.patch = end.patch;
  const auto nodes = data.second.nodes(result.patch);
  result.parents.push_back(data.partition.parent[result.patch]);
  std::array<Index, 3> column{};
  for (int k = 0; k < 3; ++k) column[k] = data.column_in_patch(result.patch, end.piece->place[k]);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::array<double, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      corners[k] = data.second.distance(result.patch, static_cast<Index>(i), column[k]);
    }
    const double distance = end.piece->distance(corners);
    if (distance < unreachable) result.seeds.push_back({nodes[i], distance});
  }
  return result;
}

// ---- A walk over the faces of a patch, down the distances of a border vertex

namespace {

/// A walk is abandoned when it becomes this many times as long as it should be.
constexpr double longer = 1.1;

/// The position of a walk that is not on an edge.
constexpr double off_the_edge = -1.0;

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// A coroutine: work that is done in parts, with other work in between.
class InParts {
 public:
  struct promise_type {
    InParts get_return_object() { return InParts(std::coroutine_handle<promise_type>::from_promise(*this)); }
    std::suspend_always initial_suspend() noexcept { return {}; }
    std::suspend_always final_suspend() noexcept { return {}; }
    void return_void() {}
    void unhandled_exception() { throw; }
  };
  explicit InParts(std::coroutine_handle<promise_type> parts) : parts_(parts) {}
  InParts(InParts&& other) noexcept : parts_(std::exchange(other.parts_, nullptr)) {}
  InParts& operator=(InParts&& other) noexcept {
    std::swap(parts_, other.parts_);
    return *this;
  }
  ~InParts() {
    if (parts_) parts_.destroy();
  }
  /// Does the next part. \return false at the end.
  bool go_on() {
    parts_.resume();
    return !parts_.done();
  }

 private:
  std::coroutine_handle<promise_type> parts_;
};

/// A step of a route, to a place through a second-layer patch. It begins or ends at a border node of the
/// patch, whose distances can be followed.
struct ChainStep {
  Index place;
  Index patch;
};

/// Follows a step from one of its ends to the other, a border node of the patch, down the distances of that
/// node; along edges if there is no patch, or from where the distances lead out of it. In each face the
/// distances of two vertices place the goal in the plane of the face.
///
/// A walk terminates: each vertex that it meets is nearer to the goal than the previous one, and after a
/// bounded number of faces between two vertices it continues along edges.
class StepWalk {
 public:
  StepWalk(const IndexData& data, Index from, const ChainStep& step)
      : data_(data),
        mesh_(*data.surface.mesh),
        geometry_(*data.geometry->windows),
        patch_(step.patch),
        from_(from),
        is_forwards_(patch_ == no_index || data.second.row_in(step.place, patch_) != no_index),
        goal_(is_forwards_ ? step.place : from),
        row_(patch_ == no_index ? no_index : data.second.row_in(goal_, patch_)),
        goal_edge_(data.surface.is_vertex(goal_) ? no_index : data.surface.point_at(goal_).edge),
        place_(is_forwards_ ? from : step.place) {
    passed_.reserve(64);
  }

  /// The walk. Each step is a cache miss, at an address that depends on the previous one: so it pauses after
  /// each prefetch, and other walks continue until the data has arrived.
  InParts walk() {
    constexpr std::suspend_always pause{};
    while (place_ != goal_ && row_ != no_index) {
      if (data_.surface.is_vertex(place_)) fetch_fan();
      co_await pause;
      for_each_neighbour([&](Index vertex) { fetch_column(vertex); });
      co_await pause;
      for_each_neighbour([&](Index vertex) { fetch_distance(vertex); });
      co_await pause;
      const std::size_t straight_from = passed_.size();
      std::size_t faces_left = 4 * static_cast<std::size_t>(data_.second.member_count(patch_)) + 64;
      at_last_ = distance(place_);
      double expected = at_last_ * longer;  // length that no continuation should exceed
      PassedFace face{no_index, no_index, no_index, place_};
      Move move = data_.surface.is_vertex(place_) ? leave_vertex(place_)
                                                  : leave_point(data_.surface.point_at(place_));
      for (face.face = move.face;; face.face = Mesh::face_of(face.entry)) {
        if (move.face == no_index || move.length > expected || --faces_left == 0) {
          passed_.resize(straight_from);
          walk_along_edges();
          co_return;
        }
        passed_.push_back(face);
        if (move.place != no_index) break;
        face = {no_index, move.halfedge, mesh_.next_around_edge(move.halfedge), no_index};
        prefetch_line(&geometry_.frame[face.entry]);
        mesh_.prefetch_around_edge(face.entry);
        co_await pause;
        fetch_column(geometry_.frame[face.entry].apex);
        co_await pause;
        const Index column = fetch_distance(geometry_.frame[face.entry].apex);
        co_await pause;
        expected = std::min(expected, move.length * longer);
        move = cross(face.entry, move, distance_at(column));
      }
      place_ = move.place;
    }
    if (place_ != goal_) walk_along_edges();
  }

  /// Whether the walk has reached its goal.
  bool arrived() const { return place_ == goal_; }
  /// The faces passed, in the direction of the step.
  std::vector<PassedFace> passed() const {
    if (is_forwards_) return passed_;
    std::vector<PassedFace> result;
    result.reserve(passed_.size());
    PassedFace by{no_index, no_index, no_index, from_};
    for (const PassedFace& at : std::views::reverse(passed_)) {
      by.face = at.face;
      result.push_back(by);
      by = {no_index, at.entry, at.exit, at.pivot};
    }
    return result;
  }

 private:
  /// Where to go from a point of a face: across an edge at a position, or to a place.
  struct Move {
    double length = unreachable;
    Index face = no_index;
    Index place = no_index;
    Index halfedge = no_index;
    double x = 0.0;  ///< position, from the first vertex of the edge
    double edge_length = 0.0;
    double at_first = unreachable;  ///< distance of the edge's first vertex
    double at_second = unreachable;
    Index first = no_index;  ///< that vertex
    Index second = no_index;
  };

  /// Prefetches the faces around the vertex where the walk is.
  void fetch_fan() const {
    for (Index corner : mesh_.corners(place_)) {
      const Index opposite = Mesh::next_in_face(corner);
      prefetch_line(&geometry_.frame[opposite]);
      prefetch_line(&mesh_.face_vertices(Mesh::face_of(corner)));
      mesh_.prefetch_around_edge(opposite);
    }
  }

  /// Calls visit(vertex) for the vertices next to the place where the walk is.
  template <class Visit>
  void for_each_neighbour(Visit&& visit) const {
    if (data_.surface.is_vertex(place_)) {
      for (Index corner : mesh_.corners(place_)) visit(mesh_.head(corner));
      return;
    }
    const Index edge = data_.surface.point_at(place_).edge;
    for (Index vertex : mesh_.edge_vertices(edge)) visit(vertex);
    mesh_.for_each_halfedge(edge, [&](Index h) { visit(geometry_.frame[h].apex); });
  }

  /// Prefetches what is needed to find the column of a vertex.
  void fetch_column(Index vertex) const {
    prefetch_line(&data_.second.place_node[vertex]);
    prefetch_line(&data_.home_patch[vertex]);
    prefetch_line(&data_.home_column[vertex]);
  }

  /// Prefetches the distance of a vertex. \return its column.
  Index fetch_distance(Index vertex) const {
    const Index column = data_.column_in_patch(patch_, vertex);
    if (column != no_index) prefetch_line(&data_.second.column_of(patch_, column).entry(row_));
    return column;
  }

  void walk_along_edges() {
    // A place inside an edge is joined to an end of that edge through a face at it.
    auto vertex_at = [&](Index place) {
      return data_.surface.is_vertex(place) ? place
                                            : mesh_.edge_vertices(data_.surface.point_at(place).edge)[0];
    };
    auto pass_face_at = [&](Index place, Index pivot) {
      if (data_.surface.is_vertex(place)) return;
      const Index h = mesh_.edge_halfedge(data_.surface.point_at(place).edge);
      passed_.push_back({Mesh::face_of(h), no_index, no_index, pivot});
    };
    const std::size_t straight_from = passed_.size();
    pass_face_at(place_, place_);
    if (path_along_edges(mesh_, vertex_at(place_), vertex_at(goal_), passed_) == unreachable) {
      passed_.resize(straight_from);
      return;
    }
    pass_face_at(goal_, vertex_at(goal_));
    place_ = goal_;
  }

  double distance_at(Index column) const {
    return column == no_index ? unreachable : data_.second.distance(patch_, row_, column);
  }

  double distance(Index place) const { return distance_at(data_.column_in_patch(patch_, place)); }

  /// The straight line from a point (px, py >= 0) across an edge on the x axis to the point beyond that has
  /// the distances at_0 and at_length from the ends of the edge.
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
    const double step_length = length_of(x - px, y + py);
    if (step_length < best.length) {
      best = {step_length, Mesh::face_of(halfedge), no_index, halfedge, crossing, length, at_0, at_length};
    }
  }

  /// Only to vertices nearer to the goal than the last one, so that rounding of the tables causes no cycles.
  void to_vertex(double step, double from_there, Index face, Index vertex, Move& best) const {
    if (from_there < at_last_ && step + from_there < best.length) {
      best = {step + from_there, face, vertex};
    }
  }

  /// Straight to the goal, if it is a place inside a side of the face and the walk has come to `x` on the
  /// edge of `halfedge`, or to the corner opposite that edge (off_the_edge).
  Move to_goal_in_face(Index halfedge, double x) const {
    Move move;
    if (goal_edge_ == no_index) return move;
    const FaceFrame& frame = geometry_.frame[halfedge];
    const double length = mesh_.edge_length(mesh_.edge_of(halfedge));
    const double goal = data_.surface.point_at(goal_).position;
    const bool from_apex = x == off_the_edge;
    const PlanePoint from = from_apex ? PlanePoint{frame.apex_x, frame.apex_depth} : PlanePoint{x, 0.0};
    auto take = [&](const PlanePoint& at) {
      move = {length_of(at[0] - from[0], at[1] - from[1]), Mesh::face_of(halfedge), goal_};
    };
    if (mesh_.edge_of(halfedge) == goal_edge_) take({goal, 0.0});
    for (const bool first : {true, false}) {
      const Index side = first ? frame.first_side(halfedge) : frame.second_side(halfedge);
      if (mesh_.edge_of(side) != goal_edge_) continue;
      // From the corner that the side shares with the edge.
      const bool reversed = first ? frame.first_side_reversed : frame.second_side_reversed;
      const double part = goal / mesh_.edge_length(goal_edge_);
      const double along = reversed ? 1.0 - part : part;
      const double corner = first ? 0.0 : length;
      take({std::lerp(corner, frame.apex_x, along), along * frame.apex_depth});
    }
    return move;
  }

  Move leave_point(const EdgePoint& point) const {
    Move start;
    start.x = point.position;
    start.edge_length = mesh_.edge_length(point.edge);
    start.first = mesh_.edge_vertices(point.edge)[0];
    start.second = mesh_.edge_vertices(point.edge)[1];
    start.at_first = distance(start.first);
    start.at_second = distance(start.second);
    Move best;
    mesh_.for_each_halfedge(point.edge, [&](Index h) {
      const Move move = cross(h, start, distance(geometry_.frame[h].apex));
      if (move.length < best.length) best = move;
    });
    return best;
  }

  Move leave_vertex(Index vertex) const {
    Move best;
    // Neighbours are consecutive in the fan: each is an end of two of the opposite edges.
    std::array<Index, 2> known{no_index, no_index};
    std::array<double, 2> at{unreachable, unreachable};
    for (Index corner : mesh_.corners(vertex)) {
      const Index opposite = Mesh::next_in_face(corner);
      const Index face = Mesh::face_of(corner);
      if (const Move move = to_goal_in_face(opposite, off_the_edge); move.place != no_index) return move;
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

  /// Across the face of a half-edge, from the point at which the last move reached its edge. The ends of the
  /// edge and their distances come with the move, and lengths from the frame: reading them elsewhere would be
  /// a cache miss.
  Move cross(Index halfedge, const Move& last, double at_apex) const {
    const double x = last.x;
    const FaceFrame& frame = geometry_.frame[halfedge];
    const double length = last.edge_length;
    const Index face = Mesh::face_of(halfedge);
    Move best = to_goal_in_face(halfedge, x);
    if (best.place != no_index) return best;
    to_vertex(length_of(frame.apex_x - x, frame.apex_depth), at_apex, face, frame.apex, best);
    to_vertex(x, last.at_first, face, last.first, best);
    to_vertex(length - x, last.at_second, face, last.second, best);
    for (const bool first : {true, false}) {
      const Index side = first ? frame.first_side(halfedge) : frame.second_side(halfedge);
      // The point in the frame of the side, whose x axis begins at the vertex that it shares with the crossed
      // edge.
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
  Index patch_;
  Index from_;  ///< where the step begins
  bool is_forwards_;
  Index goal_;
  Index row_;
  Index goal_edge_;               ///< the edge that the goal is inside; no_index if it is a vertex
  Index place_;                   ///< the last one met
  double at_last_ = unreachable;  ///< distance of that place
  std::vector<PassedFace> passed_;
};

}  // namespace

// ---- Walks back through the tables of each layer, from the end of a leg to its beginning

namespace {

/// Sums that exceed the least by no more than this factor are equal within the precision of the tables: the
/// step to the goal is then preferred.
constexpr double equal_sums = 1e-6;

class ChainBuilder {
 public:
  explicit ChainBuilder(const IndexData& data) : data_(data) {}

  /// The steps so far.
  const std::vector<ChainStep>& steps() const { return steps_; }

  void second_layer_step(Index patch, Index place) { steps_.push_back({place, patch}); }

  /// From second-layer node a to b by the table of first-layer patch `parent`; one of them is on its border.
  void first_layer_step(Index parent, Index a, Index b) {
    const bool backwards = first_row(parent, a) == no_index;
    const Index fixed = first_row(parent, backwards ? b : a);
    if (fixed == no_index) {
      second_layer_step(no_index, place_of(b));
      return;
    }
    auto from_goal = [&](Index node) { return from_row(parent, fixed, node); };
    auto lines = [&](const PatchRow& at, std::vector<float>& length, std::vector<double>& rest) {
      const auto nodes = data_.second.nodes(at.patch);
      length.resize(nodes.size());
      rest.resize(nodes.size());
      const bool inside = data_.partition.parent[at.patch] == parent;
      const Index* columns = data_.parent_column.data() + data_.second.border.begin[at.patch];
      for (std::size_t i = 0; inside && i < nodes.size(); ++i) {
        // Each entry is in a cache line of its own.
        prefetch_line(&data_.first.column_of(parent, columns[i]).entry(fixed));
      }
      data_.second.read_border(at.patch, at.row, length.data());
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        rest[i] = inside ? data_.first.distance(parent, fixed, columns[i]) : from_goal(nodes[i]);
      }
    };
    // Backwards from the other end to the goal, by the goal's distances.
    back_.clear();
    walk(data_.second, backwards ? a : b, backwards ? b : a, 1.0, from_goal, lines);
    for (std::size_t k = 0; k < back_.size(); ++k) {
      if (backwards) {
        second_layer_step(back_[k].patch, place_of(back_[k].to));
      } else {
        const Step& step = back_[back_.size() - 1 - k];
        second_layer_step(step.patch, place_of(step.from));
      }
    }
  }

  /// From one first-layer node to another by the transit table; both are given by their second-layer nodes.
  void transit_table_step(Index a, Index b) {
    const Index goal = data_.first.place_node[place_of(a)];
    auto from_goal = [&](Index node) -> double { return data_.transit_table.distance(goal, node); };
    auto lines = [&](const PatchRow& at, std::vector<float>& length, std::vector<double>& rest) {
      const auto nodes = data_.first.nodes(at.patch);
      length.resize(nodes.size());
      rest.resize(nodes.size());
      data_.first.read_border(at.patch, at.row, length.data());
      for (std::size_t i = 0; i < nodes.size(); ++i) rest[i] = from_goal(nodes[i]);
    };
    back_.clear();
    walk(data_.first, data_.first.place_node[place_of(b)], goal, 1.0 + equal_sums, from_goal, lines);
    const std::vector<Step> steps(back_.rbegin(), back_.rend());
    for (const Step& step : steps) {
      if (step.patch == no_index) {
        second_layer_step(no_index, place_of(data_.second_node[step.from]));
      } else {
        first_layer_step(step.patch, data_.second_node[step.to], data_.second_node[step.from]);
      }
    }
  }

 private:
  /// A step back: two nodes of one layer and the patch of that layer between them; no_index: along edges.
  struct Step {
    Index from, to, patch;
  };

  /// From node `here` of a layer back to `goal`: each step leads through the patch and to the node with the
  /// least sum of the step's length and that node's distance from the goal, which must decrease from node to
  /// node. `lines(patch row, lengths, rests)` reads both for all nodes of a patch. Adds to back_.
  template <class FromGoal, class Lines>
  void walk(const PatchLayer& layer, Index here, Index goal, double favour_goal, FromGoal&& from_goal,
            Lines&& lines) {
    // This loop ends: each node is the goal or nearer to it than the previous one.
    while (here != goal) {
      const double at_here = from_goal(here);
      Step next{here, goal, no_index};  // along edges if no patch leads on
      double best = unreachable;
      for (const PatchRow& at : layer.patches_of(here)) {
        lines(at, step_, rest_);
        const auto nodes = layer.nodes(at.patch);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          const bool is_goal = nodes[i] == goal;
          const double rest = is_goal ? 0.0 : rest_[i];
          const double sum = rest + static_cast<double>(step_[i]);
          if (!(sum < best * (is_goal ? favour_goal : 1.0)) || nodes[i] == here || !(rest < at_here))
            continue;
          best = sum;
          next.to = nodes[i];
          next.patch = at.patch;
        }
      }
      back_.push_back(next);
      here = next.to;
    }
  }

  Index place_of(Index second_node) const { return data_.second.node_place[second_node]; }
  Index first_row(Index parent, Index second_node) const {
    const Index node = data_.first.place_node[place_of(second_node)];
    return node == no_index ? no_index : data_.first.row_of(node, parent);
  }
  double from_row(Index parent, Index row, Index second_node) const {
    const Index column = data_.column_in_parent(parent, second_node);
    return column == no_index ? unreachable : data_.first.distance(parent, row, column);
  }

  const IndexData& data_;
  std::vector<ChainStep> steps_;
  std::vector<Step> back_;
  std::vector<float> step_;
  std::vector<double> rest_;
};

}  // namespace

// ---- A walk for each step

namespace {

/// Adds faces to a strip until it ends in the face passed next. \return false if it does not touch that face.
bool pass(const InnerSurface& surface, const PassedFace& next, FaceStrip& strip) {
  const Mesh& mesh = *surface.mesh;
  if (strip.first == no_index) {
    strip.first = next.face;
    return true;
  }
  if (next.exit == no_index && surface.is_vertex(next.pivot)) {
    return turn_around(mesh, strip, next.pivot, next.face);
  }
  if (next.exit == no_index && strip.last() == next.face) return true;
  HalfedgePair crossing{next.exit, next.entry};
  if (next.exit == no_index) {
    const Index edge = surface.point_at(next.pivot).edge;
    mesh.for_each_halfedge(edge, [&](Index h) {
      if (Mesh::face_of(h) == strip.last()) crossing.exit = h;
      if (Mesh::face_of(h) == next.face) crossing.entry = h;
    });
    if (crossing.exit == no_index || crossing.entry == no_index) return false;
  }
  strip.crossings.push_back(crossing);
  return true;
}

}  // namespace

bool strip_along_route(const IndexData& data, const GraphRoute& route, const IndexedEnd& from,
                       const IndexedEnd& to, FaceStrip& strip) {
  const Mesh& mesh = *data.surface.mesh;
  std::vector<Stage> stages;
  find_stages(data, route, {from.place, from.patch}, {to.place, to.patch}, stages);
  ChainBuilder chain(data);
  auto node_at = [&](Index place) { return data.second.place_node[place]; };
  Index place = from.place;
  for (const auto& [leg, exit] : stages) {
    if (leg.table == Leg::Table::transit) chain.transit_table_step(node_at(place), node_at(exit));
    if (leg.table == Leg::Table::first) chain.first_layer_step(leg.patch, node_at(place), node_at(exit));
    if (leg.table == Leg::Table::second) chain.second_layer_step(leg.patch, exit);
    place = exit;
  }
  std::vector<StepWalk> walks;
  walks.reserve(chain.steps().size());
  place = from.place;
  for (const ChainStep& step : chain.steps()) {
    walks.emplace_back(data, place, step);
    place = step.place;
  }
  std::vector<InParts> going;
  for (StepWalk& walk : walks) going.push_back(walk.walk());
  while (!going.empty()) std::erase_if(going, [](InParts& walk) { return !walk.go_on(); });
  strip.source = from.point;
  strip.target = to.point;
  strip.first = strip.source.face;
  strip.crossings.clear();
  for (const StepWalk& walk : walks) {
    if (!walk.arrived()) return false;
    for (const PassedFace& next : walk.passed()) {
      if (!pass(data.surface, next, strip)) return false;
    }
  }
  if (strip.first == no_index) strip.first = Mesh::face_of(mesh.corners(strip.source.vertex).front());
  if (!strip.target.is_vertex()) {
    return pass(data.surface, {strip.target.face, no_index, no_index, place}, strip);
  }
  return std::ranges::find(mesh.face_vertices(strip.last()), strip.target.vertex) !=
         mesh.face_vertices(strip.last()).end();
}

}  // namespace vorogeo
