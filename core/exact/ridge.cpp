// The ridge of an exact field: the points that several shortest paths reach.
#include "exact/ridge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

#include "exact/edge_axes.h"
#include "exact/path_tracing.h"
#include "exact/solver_state.h"
#include "support/disjoint_sets.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// Directions that differ by less are one: the end of a shadow, where the two waves agree to second order, is
/// known to the root of the rounding of distances.
constexpr double same_direction = 1e-4;
/// Distances that differ by less, relative to them and to the length of the edge, are equal.
constexpr double equal_waves = 1e-10;
/// Places this close to the end of an edge, relative to its length, are at the vertex.
constexpr double beside_vertex = 1e-7;
/// Windows so narrow, relative to their edge, may come from rounding beside a vertex or on a line.
constexpr double tiny_part = 1e-5;
/// Places this far off a line, relative to the greatest side of the face, are on it.
constexpr double on_curve = 1e-7;

/// Sources of waves this close, relative to their distance, are one.
constexpr double same_source_within = 1e-9;

double angle_in_plane(const PlanePoint& a, const PlanePoint& b) {
  return std::atan2(std::abs(cross_in_plane(a, b)), dot_in_plane(a, b));
}

/// What is seen of a (pseudo-)source from an edge, which is on the x axis.
struct RidgeWave {
  double x, y, offset;
  Index through;  ///< the face that it came through; no_index: along the edge

  explicit RidgeWave(const Window& window)
      : x(window.source_x),
        y(window.source_y),
        offset(window.offset),
        through(Mesh::face_of(window.entry())) {}
  RidgeWave(double at, double distance) : x(at), y(0.0), offset(distance), through(no_index) {}

  double distance(double at) const { return offset + std::hypot(at - x, y); }
  /// Towards the source, in the plane of a face that has the edge.
  PlanePoint direction(double at, Index face) const { return {x - at, through == face ? y : -y}; }
};

/// The same in the plane of a face, and the part of its border that it reaches.
struct PlaneWave {
  PlanePoint source{};
  double offset = 0.0;
  Index part = 0;

  double tolerance() const { return same_source_within * (std::hypot(source[0], source[1]) + offset); }
  bool may_be(double x) const { return x - source[0] <= tolerance(); }
  bool is_same(const PlaneWave& other) const {
    const PlanePoint off = minus_in_plane(other.source, source);
    return std::hypot(off[0], off[1]) + std::abs(other.offset - offset) <= tolerance();
  }
};

/// A line of the ridge in a face: where two waves are equal, or straight from a corner.
struct Curve {
  std::array<PlaneWave, 2> waves{};
  bool is_straight = false;
  PlanePoint from{}, direction{};  ///< of a straight one

  /// How far a place is from the curve, to first order, and in which direction.
  double off(const PlanePoint& place, PlanePoint& across) const {
    if (is_straight) {
      across = {-direction[1], direction[0]};
      return dot_in_plane(across, minus_in_plane(place, from));
    }
    const PlanePoint u = minus_in_plane(place, waves[0].source), v = minus_in_plane(place, waves[1].source);
    const double a = std::hypot(u[0], u[1]), b = std::hypot(v[0], v[1]);
    across = {u[0] / a - v[0] / b, u[1] / a - v[1] / b};
    const double slope = std::hypot(across[0], across[1]);
    across = {across[0] / slope, across[1] / slope};
    return (waves[0].offset + a - waves[1].offset - b) / slope;
  }
};

class RidgeFinder {
 public:
  explicit RidgeFinder(const ExactSolver& solver, const ExactSolver::State& state)
      : solver_(solver), state_(state), mesh_(state.mesh), geometry_(*state.geometry) {}

  Ridge find() {
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      if (e % items_per_checkpoint == 0) checkpoint();
      crossings_begin_.push_back(crossings_.size());
      if (mesh_.edge_length(e) > 0.0) look_along(e);
    }
    crossings_begin_.push_back(crossings_.size());
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (v % items_per_checkpoint == 0) checkpoint();
      begin_at(v);
    }
    std::ranges::sort(beginnings_, {}, &Beginning::face);
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      if (f % items_per_checkpoint == 0) checkpoint();
      join_in(f);
    }
    return std::move(ridge_);
  }

 private:
  static constexpr Index items_per_checkpoint = 1 << 10;

  /// Where a line crosses an edge.
  struct Crossing {
    double x;
    Index point;
    std::array<RidgeWave, 2> waves;
  };
  /// A line that begins at a corner of a face.
  struct Beginning {
    Index face;
    Index vertex;
    PlanePoint to;  ///< where it leaves the face, in its plane
    Index point;
  };
  /// A side of a face, and how far along it.
  using BorderPlace = std::pair<int, double>;
  /// A line at a point of the border of a face.
  struct End {
    BorderPlace at;
    PlanePoint place;
    Index point;
    Curve curve;
  };

  Index add_point(const SurfacePoint& point, double distance, double angle) {
    ridge_.points.push_back(point);
    ridge_.distance.push_back(distance);
    ridge_.angle.push_back(angle);
    return static_cast<Index>(ridge_.points.size()) - 1;
  }
  /// With the angle 0.
  Index vertex_point(Index vertex) {
    const auto [place, is_new] = point_at_vertex_.try_emplace(vertex, no_index);
    if (is_new)
      place->second = add_point(SurfacePoint::at_vertex(vertex), state_.vertices[vertex].distance, 0.0);
    return place->second;
  }
  SurfacePoint point_at(Index edge, double x) const {
    const double part = x / mesh_.edge_length(edge);
    return point_on_edge(mesh_, edge, geometry_.is_turned(edge) ? 1.0 - part : part);
  }

  /// The windows of an edge, each without the part where a path along the edge from one of its ends, at these
  /// distances, is shorter.
  std::vector<Window> shortest_windows(Index edge, double at_a, double at_b) const {
    const double length = mesh_.edge_length(edge);
    std::vector<Window> shortest;
    for (Window window : state_.envelope.windows(edge)) {
      const auto overtaken_from = [&](double distance, double source_x) {
        return vertex_takeover(distance, window.offset, source_x, window.source_y);
      };
      const double rounding = equal_waves * (window.distance(window.begin) + length);
      if (window.distance(window.begin) > at_a + window.begin + rounding) {
        if (window.distance(window.end) >= at_a + window.end) continue;
        window.begin = std::clamp(overtaken_from(at_a, window.source_x), window.begin, window.end);
      }
      if (window.distance(window.end) > at_b + length - window.end + rounding) {
        if (window.distance(window.begin) >= at_b + length - window.begin) continue;
        const double x = length - overtaken_from(at_b, length - window.source_x);
        window.end = std::clamp(x, window.begin, window.end);
      }
      shortest.push_back(window);
    }
    return shortest;
  }

  void look_along(Index edge) {
    const double length = mesh_.edge_length(edge);
    const auto [a, b] = geometry_.ends(edge);
    const double at_a = state_.vertices[a].distance, at_b = state_.vertices[b].distance;
    const std::vector<Window> windows = shortest_windows(edge, at_a, at_b);
    // What the windows leave free at the ends is reached along the edge.
    std::optional<RidgeWave> last;
    if (at_a < unreachable) last.emplace(0.0, at_a);
    double last_end = windows.empty() ? 0.5 * (length + at_b - at_a) : windows.front().begin;
    // Windows of both faces may take turns along a line, with narrow ones between.
    std::vector<std::uint8_t> is_line;
    for (const Window& window : windows) is_line.push_back(runs_along(edge, window) ? 1 : 0);
    for (std::size_t i = 1; i + 1 < windows.size(); ++i) {
      const bool is_narrow = windows[i].end - windows[i].begin <= tiny_part * length;
      if (is_narrow && is_line[i - 1] != 0 && is_line[i + 1] != 0) is_line[i] = 1;
    }
    double line_begin = 0.0;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const bool goes_on = i > 0 && is_line[i - 1] != 0;
      if (goes_on && is_line[i] == 0) run_along(edge, line_begin, last_end);
      if (!goes_on && is_line[i] != 0) line_begin = windows[i].begin;
      if (last && !(goes_on && is_line[i] != 0))
        cross_at(edge, last_end, windows[i].begin, *last, RidgeWave(windows[i]));
      last.emplace(windows[i]);
      last_end = windows[i].end;
    }
    if (!windows.empty() && is_line.back() != 0) run_along(edge, line_begin, last_end);
    if (last && at_b < unreachable) cross_at(edge, last_end, last_end, *last, {length, at_b});
  }

  /// A line crosses the edge where one wave ends and the next one begins, unless these are parts of one.
  void cross_at(Index edge, double end, double begin, const RidgeWave& one, const RidgeWave& other) {
    const double length = mesh_.edge_length(edge), x = 0.5 * (end + begin);
    if (!(x > beside_vertex * length && x < (1.0 - beside_vertex) * length)) return;
    const double distance = one.distance(x), gap = std::abs(end - begin);
    const double rounding = equal_waves * (distance + length) + (gap <= tiny_part * length ? gap : 0.0);
    if (!(distance <= state_.max_distance) || std::abs(distance - other.distance(x)) > rounding) return;
    const Index face = Mesh::face_of(mesh_.edge_halfedge(edge));
    const double angle = angle_in_plane(one.direction(x, face), other.direction(x, face));
    if (!(angle > same_direction)) return;
    crossings_.push_back({x, add_point(point_at(edge, x), distance, angle), {one, other}});
  }

  /// Whether a line runs along the part of an edge that a window of one face covers: another face brings an
  /// equal wave there.
  bool runs_along(Index edge, const Window& window) const {
    if (!(window.end - window.begin > tiny_part * mesh_.edge_length(edge)) || mesh_.is_border_edge(edge))
      return false;
    return std::ranges::all_of(std::array{1.0 / 3.0, 2.0 / 3.0}, [&](double part) {
      const double x = window.begin + part * (window.end - window.begin);
      return angle_with_other_face(edge, x, RidgeWave(window)) > same_direction;
    });
  }

  void run_along(Index edge, double begin, double end) {
    const double length = mesh_.edge_length(edge);
    const auto point_of = [&](double x) {
      if (x <= tiny_part * length) return vertex_point(geometry_.ends(edge)[0]);
      if (x >= (1.0 - tiny_part) * length) return vertex_point(geometry_.ends(edge)[1]);
      for (std::size_t i = crossings_begin_.back(); i < crossings_.size(); ++i) {
        if (std::abs(crossings_[i].x - x) <= tiny_part * length) return crossings_[i].point;
      }
      const SurfacePoint at = point_at(edge, x);
      return add_point(at, solver_.distance(at), 0.0);
    };
    const Index from = point_of(begin);
    ridge_.edges.push_back({from, point_of(end)});
  }

  /// Between the direction of a wave and that of an equal one from another face at an edge; 0 if there is
  /// none.
  double angle_with_other_face(Index edge, double x, const RidgeWave& wave) const {
    const double distance = wave.distance(x);
    if (!(distance <= state_.max_distance)) return 0.0;
    double angle = 0.0;
    for_each_face_at(mesh_, point_at(edge, x), [&](Index face, const std::array<double, 3>& weights) {
      if (face == wave.through) return;
      const BackStep step = best_back_step(state_, face, weights);
      if (!(std::abs(step.distance - distance) <= equal_waves * distance)) return;
      const FacePlane plane(geometry_, face);
      const PlanePoint toward = minus_in_plane(origin_of(step, face), plane.at(weights));
      const EdgeAxes axes(geometry_, plane, face, edge);
      const PlanePoint there{dot_in_plane(toward, axes.along), dot_in_plane(toward, axes.inwards)};
      angle = std::max(angle, angle_in_plane(wave.direction(x, face), there));
    });
    return angle;
  }

  /// Where a step back leads, in the plane of its face.
  PlanePoint origin_of(const BackStep& step, Index face) const {
    const FacePlane plane(geometry_, face);
    if (step.source != no_index) return plane.at(source_in_face(state_, step.source, face));
    if (step.vertex != no_index) return plane.corner[corner_of(face, step.vertex)];
    const EdgeAxes axes(geometry_, plane, face, mesh_.edge_of(step.halfedge));
    return {axes.origin[0] + step.x * axes.along[0], axes.origin[1] + step.x * axes.along[1]};
  }
  int corner_of(Index face, Index vertex) const {
    const auto& corners = mesh_.face_vertices(face);
    return static_cast<int>(std::ranges::find(corners, vertex) - corners.begin());
  }

  /// Lines begin at a vertex between the directions in which shortest paths arrive: behind it, at the angle
  /// halfway between two.
  void begin_at(Index vertex) {
    if (mesh_.representative(vertex) != vertex || !TangentFrame::exists_at(mesh_, vertex)) return;
    const double distance = state_.vertices[vertex].distance;
    if (!(distance <= state_.max_distance) || distance == unreachable || state_.is_source(vertex)) return;
    const bool is_open = mesh_.fan(vertex) == Mesh::Fan::open;
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
    const auto same = [](double a, double b) { return b - a <= same_direction; };
    arrivals.erase(std::ranges::unique(arrivals, same).begin(), arrivals.end());
    if (arrivals.size() > 1 && arrivals.front() + turn - arrivals.back() <= same_direction)
      arrivals.pop_back();
    for (std::size_t i = 0; i < arrivals.size(); ++i) {
      const bool is_last = i + 1 == arrivals.size();
      if (is_last && is_open) break;
      const double sector = (is_last ? arrivals.front() + turn : arrivals[i + 1]) - arrivals[i];
      const double angle = sector < std::numbers::pi ? sector : 2.0 * std::numbers::pi - sector;
      if (!(angle > same_direction)) continue;
      begin_line(frame, arrivals[i] + 0.5 * sector);
      if (const auto point = point_at_vertex_.find(vertex); point != point_at_vertex_.end())
        ridge_.angle[point->second] = std::max(ridge_.angle[point->second], angle);
    }
  }

  void begin_line(const TangentFrame& frame, double direction) {
    for (const EdgeView& view : frame.views()) {
      const double off = std::remainder(direction - view.across, frame.full_turn());
      if (!(std::abs(off) < 0.5 * std::numbers::pi)) continue;
      const Index edge = mesh_.edge_of(view.halfedge);
      const double length = mesh_.edge_length(edge);
      const double x = view.x + view.sign * view.y * std::tan(off);
      // Along a side, it is found there.
      if (!(x > beside_vertex * length && x < (1.0 - beside_vertex) * length)) continue;
      const Index face = Mesh::face_of(view.halfedge);
      const EdgeAxes axes(geometry_, FacePlane(geometry_, face), face, edge);
      const PlanePoint to{axes.origin[0] + x * axes.along[0], axes.origin[1] + x * axes.along[1]};
      beginnings_.push_back({face, frame.point().vertex, to, vertex_point(frame.point().vertex)});
      return;
    }
  }

  PlaneWave in_plane(const RidgeWave& wave, Index face, const EdgeAxes& axes) const {
    const double inside = wave.through == face ? wave.y : -wave.y;
    return {{axes.origin[0] + wave.x * axes.along[0] + inside * axes.inwards[0],
             axes.origin[1] + wave.x * axes.along[1] + inside * axes.inwards[1]},
            wave.offset,
            0};
  }

  /// Visits the half-edges of a face with their edges, in order round it. `along(x)` is how far a place of
  /// the edge is from the corner where the half-edge begins.
  template <class Visit>
  void for_each_side(Index face, Visit&& visit) const {
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * face + i, edge = mesh_.edge_of(h);
      const bool is_forth = mesh_.tail(h) == geometry_.ends(edge)[0];
      const double length = mesh_.edge_length(edge);
      visit(i, edge, [is_forth, length](double x) { return is_forth ? x : length - x; });
    }
  }

  /// In order round the face.
  std::vector<End> ends_in(Index face, const FacePlane& plane) const {
    std::vector<End> ends;
    for_each_side(face, [&](int side, Index edge, const auto& along) {
      for (auto it = std::ranges::lower_bound(beginnings_, face, {}, &Beginning::face);
           it != beginnings_.end() && it->face == face; ++it) {
        if (it->vertex != mesh_.face_vertices(face)[side]) continue;
        const PlanePoint way = minus_in_plane(it->to, plane.corner[side]);
        const double length = std::hypot(way[0], way[1]);
        Curve straight;
        straight.is_straight = true;
        straight.from = plane.corner[side];
        straight.direction = {way[0] / length, way[1] / length};
        ends.push_back({{side, 0.0}, plane.corner[side], it->point, straight});
      }
      if (crossings_begin_[edge] == crossings_begin_[edge + 1]) return;
      const EdgeAxes axes(geometry_, plane, face, edge);
      for (std::size_t k = crossings_begin_[edge]; k < crossings_begin_[edge + 1]; ++k) {
        const auto& [x, point, waves] = crossings_[k];
        Curve curve;
        // In order round the face.
        const bool is_forth = along(0.0) == 0.0;
        for (int w = 0; w < 2; ++w) curve.waves[w] = in_plane(waves[is_forth ? w : 1 - w], face, axes);
        ends.push_back({{side, along(x)},
                        {axes.origin[0] + x * axes.along[0], axes.origin[1] + x * axes.along[1]},
                        point,
                        curve});
      }
    });
    std::ranges::sort(ends, {}, &End::at);
    return ends;
  }

  /// Numbers for the parts of the border of a face, each from an end to the next: equal ones belong to one
  /// region, without a line between. So are those that one wave reaches, as all of its rays to the source do
  /// not leave its region, and neighbours in the same part.
  std::vector<Index> regions_between(Index face, const FacePlane& plane, const std::vector<End>& ends) const {
    std::vector<PlaneWave> waves;
    const auto add = [&](PlaneWave wave, const BorderPlace& at) {
      const auto before = std::ranges::lower_bound(ends, at, {}, &End::at) - ends.begin();
      wave.part = static_cast<Index>((before == 0 ? static_cast<std::ptrdiff_t>(ends.size()) : before) - 1);
      waves.push_back(wave);
    };
    // An end tells for sure what is on its two sides.
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].curve.is_straight) continue;
      for (std::size_t side : {0, 1}) {
        waves.push_back(ends[i].curve.waves[side]);
        waves.back().part = static_cast<Index>((i + ends.size() - 1 + side) % ends.size());
      }
    }
    for_each_side(face, [&](int side, Index edge, const auto& along) {
      const Index corner = mesh_.face_vertices(face)[side];
      if (geometry_.can_bend[corner] && state_.vertices[corner].distance < unreachable)
        add({plane.corner[side], state_.vertices[corner].distance, 0}, {side, 0.0});
      const double length = mesh_.edge_length(edge);
      if (!(length > 0.0)) return;
      const EdgeAxes axes(geometry_, plane, face, edge);
      for (const Window& window : state_.envelope.windows(edge)) {
        if (!(window.end - window.begin > tiny_part * length)) continue;
        add(in_plane(RidgeWave(window), face, axes), {side, along(0.5 * (window.begin + window.end))});
      }
    });
    std::ranges::sort(waves, {}, [](const PlaneWave& wave) { return wave.source[0]; });
    DisjointSets regions(static_cast<Index>(ends.size()));
    for (std::size_t i = 0; i < waves.size(); ++i) {
      for (std::size_t j = i + 1; j < waves.size() && waves[i].may_be(waves[j].source[0]); ++j) {
        if (waves[i].is_same(waves[j])) regions.join(waves[i].part, waves[j].part);
      }
    }
    std::vector<Index> region;
    for (Index part = 0; part < static_cast<Index>(ends.size()); ++part) region.push_back(regions.root(part));
    return region;
  }

  void join_in(Index face) {
    const FacePlane plane(geometry_, face);
    const std::vector<End> ends = ends_in(face, plane);
    double size = 0.0;
    for (int i = 0; i < 3; ++i) size = std::max(size, mesh_.edge_length(mesh_.edge_of(3 * face + i)));
    if (ends.size() <= 2) return join(face, plane, ends, size);
    // Ends between two parts of one region are joined with one another only.
    const std::vector<Index> region = regions_between(face, plane, ends);
    std::vector<std::size_t> open;
    const auto join_open = [&](std::size_t first) {
      std::vector<End> together;
      for (std::size_t k = first; k < open.size(); ++k) together.push_back(ends[open[k]]);
      join(face, plane, together, size);
      open.resize(first);
    };
    for (std::size_t i = 0; i < ends.size(); ++i) {
      open.push_back(i);
      const auto same = std::ranges::find(open, region[i], [&](std::size_t k) { return region[k]; });
      if (*same != i) join_open(static_cast<std::size_t>(same - open.begin()) + 1);
    }
    join_open(0);
  }

  /// Lines that meet.
  void join(Index face, const FacePlane& plane, const std::vector<End>& ends, double size) {
    if (ends.size() == 2) ridge_.edges.push_back({ends[0].point, ends[1].point});
    if (ends.size() <= 2 || join_at_junction(face, plane, ends, size)) return;
    PlanePoint middle{};
    for (const End& end : ends) {
      for (int c = 0; c < 2; ++c) middle[c] += end.place[c] / static_cast<double>(ends.size());
    }
    join_at(face, plane, ends, middle);
  }

  /// Where all lines of a face meet in one point.
  bool join_at_junction(Index face, const FacePlane& plane, const std::vector<End>& ends, double size) {
    constexpr int most_steps = 30;
    PlanePoint place{};
    for (const PlanePoint& corner : plane.corner)
      place = {place[0] + corner[0] / 3.0, place[1] + corner[1] / 3.0};
    double off = 0.0;
    for (int step = 0; step < most_steps; ++step) {
      // Gauss-Newton.
      double xx = 0.0, xy = 0.0, yy = 0.0, x = 0.0, y = 0.0;
      off = 0.0;
      for (const End& end : ends) {
        PlanePoint across{};
        const double own = end.curve.off(place, across);
        off = std::max(off, std::abs(own));
        xx += across[0] * across[0];
        xy += across[0] * across[1];
        yy += across[1] * across[1];
        x += across[0] * own;
        y += across[1] * own;
      }
      const double determinant = xx * yy - xy * xy;
      const PlanePoint move{(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant};
      if (!std::isfinite(move[0] + move[1])) return false;
      place = minus_in_plane(place, move);
      if (std::hypot(move[0], move[1]) <= 1e-14 * size) break;
    }
    if (!(off <= on_curve * size)) return false;
    const auto weights = weights_of(plane, place);
    if (!std::ranges::all_of(weights, [](double weight) { return weight >= -1e-9; })) return false;
    join_at(face, plane, ends, place);
    return true;
  }

  static std::array<double, 3> weights_of(const FacePlane& plane, const PlanePoint& place) {
    const auto area = [&](const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
      return cross_in_plane(minus_in_plane(b, a), minus_in_plane(c, a));
    };
    const auto& [a, b, c] = plane.corner;
    const double whole = area(a, b, c);
    return {area(place, b, c) / whole, area(a, place, c) / whole, area(a, b, place) / whole};
  }

  void join_at(Index face, const FacePlane& plane, const std::vector<End>& ends, const PlanePoint& place) {
    auto weights = weights_of(plane, place);
    double sum = 0.0, angle = 0.0;
    for (double& weight : weights) sum += weight = std::max(weight, 0.0);
    for (double& weight : weights) weight /= sum;
    for (const End& end : ends) angle = std::max(angle, ridge_.angle[end.point]);
    const SurfacePoint at = canonical(mesh_, SurfacePoint::in_face(face, weights));
    const Index junction = add_point(at, solver_.distance(at), angle);
    for (const End& end : ends) ridge_.edges.push_back({end.point, junction});
  }

  const ExactSolver& solver_;
  const ExactSolver::State& state_;
  const Mesh& mesh_;
  const ExactGeometry& geometry_;
  Ridge ridge_;
  std::vector<Crossing> crossings_;
  std::vector<std::size_t> crossings_begin_;  ///< by edge
  std::vector<Beginning> beginnings_;         ///< by face
  std::unordered_map<Index, Index> point_at_vertex_;
};

}  // namespace

Ridge ExactSolver::ridge() const {
  state_->require_windows();
  return RidgeFinder(*this, *state_).find();
}

}  // namespace vorogeo
