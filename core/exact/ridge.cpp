// The ridge of an exact field: the points that several shortest paths reach.
#include "exact/ridge.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "exact/edge_axes.h"
#include "exact/face_splits.h"
#include "exact/path_tracing.h"
#include "exact/wave_tree.h"
#include "support/disjoint_sets.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// The angle defect of a vertex from which on a line begins there.
constexpr double least_defect = 1e-7;
/// Distances that differ by less, relative to them, are equal.
constexpr double equal_waves = 1e-10;
/// Places up to this far off a line, relative to the longest side of the face, are on it.
constexpr double on_curve = 1e-7;
/// Lines that meet this close to an end of one of them, relative to the same side, meet at that end.
constexpr double one_place = 1e-9;
/// The least weight of a junction: it lies inside its face.
constexpr double inside_face = 1e-12;

double angle_in_plane(const PlanePoint& a, const PlanePoint& b) {
  return std::atan2(std::abs(cross_in_plane(a, b)), dot_in_plane(a, b));
}

/// A wave in the plane of a face.
struct PlaneWave {
  PlanePoint source{};
  double offset = unreachable;

  double distance(const PlanePoint& place) const {
    return offset + std::hypot(place[0] - source[0], place[1] - source[1]);
  }
};

/// The places where three waves are equal: the differences of the equations of their circles are linear in
/// the place and in the distance. There are up to two; missing ones are NaN.
std::array<PlanePoint, 2> meetings_of(const std::array<PlaneWave, 3>& waves) {
  const PlanePoint u = minus_in_plane(waves[1].source, waves[0].source),
                   v = minus_in_plane(waves[2].source, waves[0].source);
  const double u_later = waves[1].offset - waves[0].offset, v_later = waves[2].offset - waves[0].offset;
  const double twice = 2.0 * cross_in_plane(u, v);
  const double u_part = dot_in_plane(u, u) - u_later * u_later,
               v_part = dot_in_plane(v, v) - v_later * v_later;
  // From the first source: at + distance * by.
  const PlanePoint at{(u_part * v[1] - v_part * u[1]) / twice, (v_part * u[0] - u_part * v[0]) / twice};
  const PlanePoint by{2.0 * (u_later * v[1] - v_later * u[1]) / twice,
                      2.0 * (v_later * u[0] - u_later * v[0]) / twice};
  const double a = dot_in_plane(by, by) - 1.0, b = dot_in_plane(at, by), c = dot_in_plane(at, at);
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  const double q = b < 0.0 ? root - b : -root - b;
  std::array<PlanePoint, 2> places{};
  for (int i = 0; i < 2; ++i) {
    const double distance = i == 0 ? c / q : q / a;
    const bool is_there = distance >= std::max({0.0, u_later, v_later}) && distance < unreachable;
    for (int k = 0; k < 2; ++k)
      places[i][k] = is_there ? waves[0].source[k] + at[k] + distance * by[k] : std::nan("");
  }
  return places;
}

// ---- The lines as a graph: all that lies between the areas of a wave tree, without its dead ends

/// Where a line ends in a face: at a place on an edge, between two of its parts, or at a vertex.
struct LineEnd {
  Index node;
  Index gap;             ///< behind this piece of the border of the face
  bool is_dead = false;  ///< no line: both sides are one wave, which a vertex has parted
};

/// Ends of lines that meet in a face; two ends are those of one line.
struct Meeting {
  Index face;
  std::vector<LineEnd> ends;  ///< in order round the face
};

/// The number of a part is also the node at the place where this part ends and the next one of its edge
/// begins; behind these numbers follow the nodes at vertices.
class LineGraph {
 public:
  LineGraph(const ExactSolver::State& state, const WaveTree& tree)
      : state_(state),
        mesh_(state.mesh),
        geometry_(*state.geometry),
        tree_(tree),
        part_count_(tree.first_part(mesh_.edge_count())),
        sectors_(2 * mesh_.edge_count() + 3 * mesh_.face_count()),
        is_own_(2 * static_cast<std::size_t>(mesh_.edge_count()) +
                    3 * static_cast<std::size_t>(mesh_.face_count()),
                0),
        has_leaf_(mesh_.vertex_count(), false) {
    for_each_face([&](Index face) { join_sectors(face); });
    mark_own();
    for_each_face([&](Index face) { join_runs(face); });
    for_each_face([&](Index face) { find_meetings(face); });
    prune();
  }

  const std::vector<Meeting>& meetings() const { return meetings_; }
  std::size_t node_count() const { return static_cast<std::size_t>(part_count_) + vertex_of_.size(); }
  bool is_vertex(Index node) const { return node >= part_count_; }
  Index vertex(Index node) const { return vertex_of_[node - part_count_]; }

 private:
  template <class Visit>
  void for_each_face(Visit&& visit) {
    for (const Index f : checked(mesh_.face_count())) {
      const auto& corners = mesh_.face_vertices(f);
      if (std::ranges::all_of(corners, [&](Index v) { return state_.vertices[v].distance == unreachable; }))
        continue;
      tree_.border_of(f, border_);
      visit(f);
    }
  }

  // Sectors around a vertex: ends of edges and corners of faces that are one area there.

  Index at_edge_end(Index edge, Index vertex) const {
    return 2 * edge + (geometry_.ends(edge)[0] == vertex ? 0 : 1);
  }
  Index at_corner(Index halfedge) const { return 2 * mesh_.edge_count() + halfedge; }

  /// The vertex at the gap behind a piece of the border; no_index inside a side.
  Index vertex_at_gap(Index face, Index gap) const {
    const auto& piece = border_[gap];
    const auto& next = border_[(gap + 1) % border_.size()];
    if (piece.part == no_index) return mesh_.tail(3 * face + piece.side);
    if (next.part == no_index || next.side != piece.side) return mesh_.head(3 * face + piece.side);
    return no_index;
  }
  Index sector_at(Index face, const WaveTree::Piece& piece, Index vertex) const {
    const Index h = 3 * face + piece.side;
    return piece.part == no_index ? at_corner(h) : at_edge_end(mesh_.edge_of(h), vertex);
  }
  template <class Visit>
  void for_each_vertex_gap(Index face, Visit&& visit) {
    for (Index gap = 0; gap < static_cast<Index>(border_.size()); ++gap) {
      const Index vertex = vertex_at_gap(face, gap);
      if (vertex == no_index) continue;
      const auto& next = border_[(gap + 1) % border_.size()];
      visit(border_[gap].area == next.area, sector_at(face, border_[gap], vertex),
            sector_at(face, next, vertex));
    }
  }

  void join_sectors(Index face) {
    for_each_vertex_gap(face, [&](bool is_one, Index before, Index behind) {
      if (is_one) sectors_.join(before, behind);
    });
    for (const auto& piece : border_) {
      if (piece.part == no_index) corners_.push_back(3 * face + piece.side);
    }
  }

  /// Marks the sectors of a vertex: the one through which it was reached, and those of paths that turn there.
  void mark_own() {
    for (const Index corner : corners_) is_own_[sectors_.root(at_corner(corner))] = 1;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (const Index edge = tree_.arrival(v); edge != no_index)
        is_own_[sectors_.root(at_edge_end(edge, v))] = 1;
    }
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const auto [a, b] = geometry_.ends(e);
      if (tree_.parts(e).front().from == Origin{Origin::vertex, a}) is_own_[sectors_.root(2 * e)] = 1;
      if (tree_.parts(e).back().from == Origin{Origin::vertex, b}) is_own_[sectors_.root(2 * e + 1)] = 1;
    }
    runs_ = sectors_;
  }
  bool is_own(Index sector) { return is_own_[sectors_.root(sector)] != 0; }

  /// Joins sectors side by side to which the vertex does not belong: lines around them go on at the vertex.
  void join_runs(Index face) {
    for_each_vertex_gap(face, [&](bool is_one, Index before, Index behind) {
      if (!is_one && !is_own(before) && !is_own(behind)) runs_.join(before, behind);
    });
  }

  Index add_node(Index vertex, bool is_kept) {
    vertex_of_.push_back(vertex);
    if (is_kept) kept_.push_back(part_count_ + static_cast<Index>(vertex_of_.size()) - 1);
    return part_count_ + static_cast<Index>(vertex_of_.size()) - 1;
  }

  Index node_at_gap(Index face, Index gap) {
    const auto& piece = border_[gap];
    const auto& next = border_[(gap + 1) % border_.size()];
    const Index vertex = vertex_at_gap(face, gap);
    if (vertex == no_index) return std::min(piece.part, next.part);
    const Index before = sector_at(face, piece, vertex), behind = sector_at(face, next, vertex);
    if (is_own(before) && is_own(behind)) {
      // A line ends here; several may end at one vertex, as paths go on between them. At a convex vertex,
      // which paths pass on both sides, one of them stays.
      const bool stays = !has_leaf_[vertex] && begins_line(vertex);
      if (stays) has_leaf_[vertex] = true;
      return add_node(vertex, stays);
    }
    const auto [place, is_new] =
        node_of_run_.try_emplace(runs_.root(is_own(before) ? behind : before), no_index);
    if (is_new) place->second = add_node(vertex, state_.vertices[vertex].distance == unreachable);
    return place->second;
  }

  bool begins_line(Index vertex) const {
    return mesh_.fan(vertex) == Mesh::Fan::closed && !state_.is_source(vertex) &&
           mesh_.total_angle(vertex) < 2.0 * std::numbers::pi - least_defect;
  }

  void find_meetings(Index face) {
    WaveTree::gaps_before(border_, before_);
    std::vector<bool> seen(border_.size(), false);
    for (Index gap = 0; gap < static_cast<Index>(border_.size()); ++gap) {
      if (seen[gap] || before_[gap] == gap) continue;
      Meeting meeting{face, {}};
      for (Index k = gap; !seen[k]; k = before_[k]) {
        seen[k] = true;
        meeting.ends.push_back({node_at_gap(face, k), k});
      }
      std::ranges::sort(meeting.ends, {}, &LineEnd::gap);
      meetings_.push_back(std::move(meeting));
    }
  }

  /// Removes lines that end neither at a convex vertex nor on the border of the mesh: on their two sides are
  /// parts of one wave, which a vertex has parted.
  void prune() {
    const std::size_t count = node_count();
    std::vector<Index> begin(count + 1, 0);
    for (const Meeting& meeting : meetings_) {
      for (const LineEnd& end : meeting.ends) ++begin[end.node + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> meeting_of(begin.back()), place(begin.begin(), begin.end() - 1);
    for (std::size_t m = 0; m < meetings_.size(); ++m) {
      for (const LineEnd& end : meetings_[m].ends) meeting_of[place[end.node]++] = static_cast<Index>(m);
    }
    std::vector<Index> degree(count), alive(meetings_.size());
    for (std::size_t n = 0; n < count; ++n) degree[n] = begin[n + 1] - begin[n];
    for (std::size_t m = 0; m < meetings_.size(); ++m)
      alive[m] = static_cast<Index>(meetings_[m].ends.size());
    std::vector<bool> is_kept(count, false);
    for (const Index node : kept_) is_kept[node] = true;
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      if (!mesh_.is_border_edge(e)) continue;
      for (Index p = tree_.first_part(e); p < tree_.first_part(e + 1); ++p) is_kept[p] = true;
      // Where another wave reaches the vertex at its end, the line between the two comes to the border there.
      for (const Index sector : {2 * e, 2 * e + 1}) {
        if (const auto run = node_of_run_.find(runs_.root(sector)); run != node_of_run_.end())
          is_kept[run->second] = true;
      }
    }
    for (const auto& [sector, node] : node_of_run_) {
      const bool begins = !has_leaf_[vertex(node)] && begins_line(vertex(node));
      if (!begins) continue;
      has_leaf_[vertex(node)] = true;
      is_kept[node] = true;
    }
    std::vector<Index> leaves;
    const auto look_at = [&](Index node) {
      if (degree[node] == 1 && !is_kept[node]) leaves.push_back(node);
    };
    for (std::size_t n = 0; n < count; ++n) look_at(static_cast<Index>(n));
    std::vector<bool> is_gone(count, false);
    while (!leaves.empty()) {
      const Index leaf = leaves.back();
      leaves.pop_back();
      is_gone[leaf] = true;
      for (Index k = begin[leaf]; k < begin[leaf + 1]; ++k) {
        const Index m = meeting_of[k];
        if (alive[m] == 0 || --alive[m] > 1) continue;
        alive[m] = 0;
        for (const LineEnd& end : meetings_[m].ends) {
          if (is_gone[end.node]) continue;
          --degree[end.node];
          look_at(end.node);
        }
      }
    }
    for (std::size_t m = 0; m < meetings_.size(); ++m) {
      if (alive[m] == 0) meetings_[m].ends.clear();
      for (LineEnd& end : meetings_[m].ends) end.is_dead = is_gone[end.node];
    }
    std::erase_if(meetings_, [](const Meeting& meeting) {
      return std::ranges::all_of(meeting.ends, &LineEnd::is_dead);
    });
  }

  const ExactSolver::State& state_;
  const Mesh& mesh_;
  const ExactGeometry& geometry_;
  const WaveTree& tree_;
  Index part_count_;
  std::vector<WaveTree::Piece> border_;  ///< of the face being visited
  std::vector<Index> before_;
  DisjointSets sectors_, runs_{0};
  std::vector<std::uint8_t> is_own_;  ///< by root of a sector
  std::vector<Index> corners_;        ///< the corners that are pieces of a border
  std::vector<bool> has_leaf_;        ///< by vertex
  std::vector<Index> vertex_of_;      ///< by node at a vertex
  std::vector<Index> kept_;           ///< nodes where lines may end
  std::unordered_map<Index, Index> node_of_run_;
  std::vector<Meeting> meetings_;
};

// ---- The lines as points and edges

class RidgeMaker {
 public:
  RidgeMaker(const ExactSolver& solver, const ExactSolver::State& state, const WaveTree& tree)
      : solver_(solver),
        state_(state),
        mesh_(state.mesh),
        geometry_(*state.geometry),
        tree_(tree),
        graph_(state, tree),
        point_of_node_(graph_.node_count(), no_index) {}

  Ridge make() {
    std::size_t count = 0;
    for (const Meeting& meeting : graph_.meetings()) {
      if (++count % elements_per_checkpoint == 0) checkpoint();
      ends_.clear();
      std::ranges::copy_if(meeting.ends, std::back_inserter(ends_),
                           [](const LineEnd& end) { return !end.is_dead; });
      if (ends_.size() == 2) {
        add_line(point_of(ends_[0].node), point_of(ends_[1].node));
      } else {
        join(meeting);
      }
    }
    return without_far();
  }

 private:
  /// What lies between two lines, going round a face: a wave, or the waves into which vertices have parted
  /// it, each to the left of the parting from the next.
  struct Side {
    struct Parting {
      PlanePoint place, inwards;
    };
    std::vector<PlaneWave> waves;
    std::vector<Parting> partings;

    const PlaneWave& at(const PlanePoint& place) const {
      std::size_t i = 0;
      while (i < partings.size() &&
             cross_in_plane(partings[i].inwards, minus_in_plane(place, partings[i].place)) < 0.0)
        ++i;
      return waves[i];
    }
  };
  struct End {
    PlanePoint place;
    Index point;
    Side behind;  ///< up to the next end
  };

  Index add_point(const SurfacePoint& point, double distance, double angle) {
    ridge_.points.push_back(point);
    ridge_.distance.push_back(distance);
    ridge_.angle.push_back(angle);
    return static_cast<Index>(ridge_.points.size()) - 1;
  }
  void add_line(Index a, Index b) { ridge_.edges.push_back({a, b}); }

  Index point_of(Index node) {
    Index& number = point_of_node_[node];
    if (number != no_index) return number;
    if (graph_.is_vertex(node)) {
      const Index vertex = graph_.vertex(node);
      return number = add_point(SurfacePoint::at_vertex(vertex), state_.vertices[vertex].distance,
                                angle_at(vertex));
    }
    const EdgePart &part = tree_.part(node), &next = tree_.part(node + 1);
    const Index edge = edge_of(node), face = Mesh::face_of(mesh_.edge_halfedge(edge));
    const double x = part.end, fraction = x / mesh_.edge_length(edge);
    const SurfacePoint point =
        point_on_edge(mesh_, edge, geometry_.is_turned(edge) ? 1.0 - fraction : fraction);
    return number = add_point(point, std::min(part.distance(x), next.distance(x)),
                              angle_in_plane(part.direction(x, face), next.direction(x, face)));
  }
  /// The edge of a part.
  Index edge_of(Index part) const {
    Index low = 0, high = mesh_.edge_count();
    while (high - low > 1) {
      const Index middle = (low + high) / 2;
      (tree_.first_part(middle) <= part ? low : high) = middle;
    }
    return low;
  }

  /// The greatest angle between directions in which shortest paths arrive at a vertex side by side.
  double angle_at(Index vertex) const {
    const double distance = state_.vertices[vertex].distance;
    if (!TangentFrame::exists_at(mesh_, vertex) || distance == unreachable) return 0.0;
    const TangentFrame frame(geometry_, SurfacePoint::at_vertex(vertex));
    const double turn = frame.full_turn();
    std::vector<double> arrivals;
    for_each_face_at(mesh_, frame.point(), [&](Index face, const std::array<double, 3>& weights) {
      const BackStep step = best_back_step(state_, face, weights);
      if (!(step.distance <= distance * (1.0 + equal_waves))) return;
      double angle = 0.0;
      if (step.halfedge != no_index) {
        angle = frame.view(step.halfedge).angle_to(step.x);
      } else if (step.vertex != no_index) {
        angle = frame.angle_to(face, step.vertex);
      } else {
        angle = frame.angle_in_face(face, source_in_face(state_, step.source, face));
      }
      arrivals.push_back(angle - turn * std::floor(angle / turn));
    });
    std::ranges::sort(arrivals);
    double greatest = 0.0;
    for (std::size_t i = 0; i < arrivals.size(); ++i) {
      const bool is_last = i + 1 == arrivals.size();
      if (is_last && mesh_.fan(vertex) == Mesh::Fan::open) break;
      const double sector = (is_last ? arrivals.front() + turn : arrivals[i + 1]) - arrivals[i];
      greatest = std::max(greatest, sector < std::numbers::pi ? sector : 2.0 * std::numbers::pi - sector);
    }
    return greatest;
  }

  // Lines that meet in a face

  PlaneWave wave_of(const WaveTree::Piece& piece, Index face, const FacePlane& plane) const {
    if (piece.part != no_index) return wave_of(piece.part, mesh_.edge_of(3 * face + piece.side), face, plane);
    switch (piece.area.kind) {
      case Origin::part:
        for (int i = 0; i < 3; ++i) {
          const Index edge = mesh_.edge_of(3 * face + i);
          if (piece.area.id >= tree_.first_part(edge) && piece.area.id < tree_.first_part(edge + 1))
            return wave_of(piece.area.id, edge, face, plane);
        }
        return {};
      case Origin::vertex:
        return {plane.corner[piece.side], state_.vertices[piece.area.id].distance};
      case Origin::source:
        return {plane.at(source_in_face(state_, piece.area.id, face)), state_.sources[piece.area.id].offset};
      default:
        return {};
    }
  }
  PlaneWave wave_of(Index number, Index edge, Index face, const FacePlane& plane) const {
    const EdgePart& part = tree_.part(number);
    if (!(mesh_.edge_length(edge) > 0.0)) return {};
    const EdgeAxes axes(geometry_, plane, face, edge);
    const double inside = part.through == face ? part.y : -part.y;
    return {{axes.origin[0] + part.x * axes.along[0] + inside * axes.inwards[0],
             axes.origin[1] + part.x * axes.along[1] + inside * axes.inwards[1]},
            part.offset};
  }

  /// The ends in order round the face, beginning with one that is not dead.
  std::vector<End> ends_of(const Meeting& meeting, const FacePlane& plane) {
    tree_.border_of(meeting.face, border_);
    std::vector<End> ends;
    const auto first = std::ranges::find(meeting.ends, false, &LineEnd::is_dead) - meeting.ends.begin();
    for (std::size_t k = 0; k < meeting.ends.size(); ++k) {
      const auto& [node, gap, is_dead] = meeting.ends[(first + k) % meeting.ends.size()];
      const auto& piece = border_[gap];
      const PlaneWave before = wave_of(piece, meeting.face, plane),
                      behind = wave_of(border_[(gap + 1) % border_.size()], meeting.face, plane);
      PlanePoint place{}, inwards{};
      if (graph_.is_vertex(node)) {
        const auto& corners = mesh_.face_vertices(meeting.face);
        place = plane.corner[std::ranges::find(corners, graph_.vertex(node)) - corners.begin()];
        for (const PlanePoint& corner : plane.corner) {
          for (int c = 0; c < 2; ++c) inwards[c] += corner[c] - place[c];
        }
      } else {
        const EdgeAxes axes(geometry_, plane, meeting.face, mesh_.edge_of(3 * meeting.face + piece.side));
        const double x = tree_.part(node).end;
        place = {axes.origin[0] + x * axes.along[0], axes.origin[1] + x * axes.along[1]};
        inwards = axes.inwards;
      }
      if (!is_dead) {
        ends.push_back({place, point_of(node), {{behind}, {}}});
        continue;
      }
      // A dead end parts the wave along a ray from the farther source of the waves on its two sides.
      Side& side = ends.back().behind;
      const auto part = [&](const PlaneWave& wave, const PlaneWave& farther) {
        PlanePoint ray = minus_in_plane(place, farther.source);
        if (dot_in_plane(ray, inwards) < 0.0) ray = {-ray[0], -ray[1]};
        side.waves.push_back(wave);
        side.partings.push_back({place, ray});
      };
      if (graph_.is_vertex(node) && before.source != place && behind.source != place) {
        // At a corner, the corner's own wave lies between them, which need not come to the border again.
        part({place, state_.vertices[graph_.vertex(node)].distance}, before);
        part(behind, behind);
      } else {
        part(behind, before.offset < behind.offset ? before : behind);
      }
    }
    return ends;
  }

  void join(const Meeting& meeting) {
    const FacePlane plane(geometry_, meeting.face);
    std::vector<End> ends = ends_of(meeting, plane);
    double size = 0.0;
    for (int i = 0; i < 3; ++i) size = std::max(size, mesh_.edge_length(mesh_.edge_of(3 * meeting.face + i)));
    while (ends.size() > 2 && join_two(meeting.face, plane, size, ends)) {
    }
    if (ends.size() == 2) return add_line(ends[0].point, ends[1].point);
    PlanePoint middle{};
    for (const End& end : ends) {
      for (int c = 0; c < 2; ++c) middle[c] += end.place[c] / static_cast<double>(ends.size());
    }
    double angle = 0.0;
    for (const End& end : ends) angle = std::max(angle, ridge_.angle[end.point]);
    join_at(meeting.face, plane, size, middle, angle, ends);
  }

  /// Joins, of three or more lines, the two neighbours that meet first, where no other wave is nearer. The
  /// area between them ends, and one line goes on. \return false if no two meet.
  bool join_two(Index face, const FacePlane& plane, double size, std::vector<End>& ends) {
    const std::size_t count = ends.size();
    double most = -unreachable, angle = 0.0;
    std::size_t first = count;
    PlanePoint place{};
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      const std::array<const Side*, 3> sides{&ends[(i + count - 1) % count].behind, &ends[i].behind,
                                             &ends[next].behind};
      PlanePoint at{};
      std::array<PlaneWave, 3> waves{};
      if (!meet(sides, plane, at, waves)) continue;
      double nearest = unreachable;
      for (const End& end : ends) nearest = std::min(nearest, end.behind.at(at).distance(at));
      double room = nearest - waves[0].distance(at);
      if (!(room > -on_curve * size)) continue;
      // A meeting where one of them ends comes first, as on a border, which lines meet without crossing it.
      for (const std::size_t k : {i, next}) {
        if (is_at(ends[k], at, size)) room = unreachable;
      }
      if (!(room > most)) continue;
      most = room;
      first = i;
      place = at;
      angle = 0.0;
      for (int k = 0; k < 3; ++k) {
        angle = std::max(angle, angle_in_plane(minus_in_plane(waves[k].source, at),
                                               minus_in_plane(waves[(k + 1) % 3].source, at)));
      }
    }
    if (first == count) return false;
    const std::size_t second = (first + 1) % count;
    const std::array both{ends[first], ends[second]};
    ends[first] = {place, join_at(face, plane, size, place, angle, both), both[1].behind};
    ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(second));
    return true;
  }

  /// Where waves of three sides meet in the face, each in the part of its side that it has.
  static bool meet(const std::array<const Side*, 3>& sides, const FacePlane& plane, PlanePoint& place,
                   std::array<PlaneWave, 3>& waves) {
    for (const PlaneWave& one : sides[0]->waves) {
      for (const PlaneWave& two : sides[1]->waves) {
        for (const PlaneWave& three : sides[2]->waves) {
          for (const PlanePoint& at : meetings_of({one, two, three})) {
            if (!is_inside(plane, at) || &sides[0]->at(at) != &one || &sides[1]->at(at) != &two ||
                &sides[2]->at(at) != &three)
              continue;
            place = at;
            waves = {one, two, three};
            return true;
          }
        }
      }
    }
    return false;
  }

  static bool is_at(const End& end, const PlanePoint& place, double size) {
    const PlanePoint off = minus_in_plane(end.place, place);
    return std::hypot(off[0], off[1]) <= one_place * size;
  }
  static bool is_inside(const FacePlane& plane, const PlanePoint& place) {
    return std::ranges::all_of(weights_of(plane, place), [](double weight) { return weight >= -1e-9; });
  }

  /// \return the point there.
  Index join_at(Index face, const FacePlane& plane, double size, const PlanePoint& place, double angle,
                std::span<const End> ends) {
    // Several lines that end at one vertex stay apart.
    const auto at_end = std::ranges::find_if(ends, [&](const End& end) {
      return is_at(end, place, size) && std::ranges::count(ends, end.point, &End::point) == 1;
    });
    const Index junction = at_end == ends.end() ? add_junction(face, plane, place, angle) : at_end->point;
    for (const End& end : ends) {
      if (end.point != junction) add_line(end.point, junction);
    }
    return junction;
  }

  static std::array<double, 3> weights_of(const FacePlane& plane, const PlanePoint& place) {
    const auto area = [&](const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
      return cross_in_plane(minus_in_plane(b, a), minus_in_plane(c, a));
    };
    const auto& [a, b, c] = plane.corner;
    const double whole = area(a, b, c);
    return {area(place, b, c) / whole, area(a, place, c) / whole, area(a, b, place) / whole};
  }

  Index add_junction(Index face, const FacePlane& plane, const PlanePoint& place, double angle) {
    auto weights = weights_of(plane, place);
    double sum = 0.0;
    // A junction on a side of the face would count as a place where lines come to the border.
    for (double& weight : weights) sum += weight = std::max(weight, inside_face);
    for (double& weight : weights) weight /= sum;
    // A face without area.
    if (!std::isfinite(weights[0] + weights[1] + weights[2])) weights = {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
    const auto at = SurfacePoint::in_face(face, weights);
    return add_point(at, solver_.distance(at), angle);
  }

  /// Without lines beyond the limit of the run.
  Ridge without_far() {
    const auto is_far = [&](Index point) {
      return !(ridge_.distance[point] <= state_.max_distance) || ridge_.distance[point] == unreachable;
    };
    std::vector<bool> is_gone;
    for (const auto& [a, b] : ridge_.edges) is_gone.push_back(is_far(a) || is_far(b));
    return without_edges(ridge_, is_gone);
  }

  const ExactSolver& solver_;
  const ExactSolver::State& state_;
  const Mesh& mesh_;
  const ExactGeometry& geometry_;
  const WaveTree& tree_;
  LineGraph graph_;
  Ridge ridge_;
  std::vector<WaveTree::Piece> border_;
  std::vector<LineEnd> ends_;  ///< the ends of a meeting that are not dead
  std::vector<Index> point_of_node_;
};

/// All sources inside the faces in which one source is nearest to no point of the face's border, so that no
/// area shows it.
std::vector<Index> sources_of_enclosed_regions(const ExactSolver::State& state, const WaveTree& tree) {
  const auto is_inside = [&](Index source) {
    const SurfacePoint& point = state.sources[source].point;
    return !point.is_vertex() && std::ranges::all_of(point.barycentric, [](double w) { return w > 0.0; });
  };
  std::vector<Index> found, inside;
  std::vector<bool> is_seen(state.sources.size(), false);
  std::vector<WaveTree::Piece> border;
  for (Index s = 0; s < static_cast<Index>(state.sources.size()); ++s) {
    if (is_seen[s] || !is_inside(s)) continue;
    inside.clear();
    for (const Index source : state.sources_in(state.sources[s].point.face)) {
      if (!is_inside(source)) continue;
      inside.push_back(source);
      is_seen[source] = true;
    }
    tree.border_of(state.sources[s].point.face, border);
    const auto has_area = [&](Index source) {
      return std::ranges::any_of(border, [&](const auto& piece) {
        return piece.area == Origin{Origin::source, source};
      });
    };
    if (!std::ranges::all_of(inside, has_area)) found.insert(found.end(), inside.begin(), inside.end());
  }
  return found;
}

}  // namespace

Ridge without_edges(const Ridge& ridge, const std::vector<bool>& is_gone) {
  Ridge rest;
  std::vector<Index> number(ridge.points.size(), no_index);
  for (std::size_t e = 0; e < ridge.edges.size(); ++e) {
    if (is_gone[e]) continue;
    std::array<Index, 2>& edge = rest.edges.emplace_back(ridge.edges[e]);
    for (Index& point : edge) {
      if (number[point] == no_index) {
        number[point] = static_cast<Index>(rest.points.size());
        rest.points.push_back(ridge.points[point]);
        rest.distance.push_back(ridge.distance[point]);
        rest.angle.push_back(ridge.angle[point]);
      }
      point = number[point];
    }
  }
  return rest;
}

Ridge ExactSolver::ridge() const {
  state_->require_windows();
  const WaveTree tree(*state_);
  const std::vector<Index> inside = sources_of_enclosed_regions(*state_, tree);
  if (inside.empty()) return RidgeMaker(*this, *state_, tree).make();
  const SplitAtSources split(*state_->geometry, state_->sources, inside);
  ExactSolver solver(split.mesh());
  solver.run(split.sources(), {.max_distance = state_->max_distance});
  const WaveTree tree_over_parts(*solver.state_);
  Ridge ridge = RidgeMaker(solver, *solver.state_, tree_over_parts).make();
  for (SurfacePoint& point : ridge.points) point = split.given_point(point);
  return ridge;
}

}  // namespace vorogeo
