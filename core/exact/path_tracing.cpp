// The best last segment of a path into a face, and paths back to the source, one face at a time.
#include "exact/path_tracing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/exact_geometry.h"
#include "exact/exact_solver.h"
#include "exact/surface_path.h"
#include "support/progress.h"

namespace vorogeo {

// ---- The best last segment of a path into a face, and distances at any point of the surface

namespace {

/// Crossings of an edge are one place up to this rounding.
constexpr double same_place = 1e-12;

double distance_in_plane(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

}  // namespace

std::vector<Index> ExactSolver::State::sources_in(Index face) const {
  std::vector<Index> found;
  const auto [begin, end] = face_sources.equal_range(face);
  for (auto it = begin; it != end; ++it) found.push_back(it->second);
  return found;
}

std::array<double, 3> source_in_face(const ExactSolver::State& state, Index source, Index face) {
  const SurfacePoint& point = state.sources[source].point;
  if (point.face == face) return point.barycentric;
  std::array<double, 3> result{};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (state.mesh.face_vertices(point.face)[i] == state.mesh.face_vertices(face)[k]) {
        result[k] = point.barycentric[i];
      }
    }
  }
  return result;
}

BackStep best_back_step(const ExactSolver::State& state, Index face, const std::array<double, 3>& barycentric,
                        const PassedPlaces& avoided) {
  const FacePlane plane(*state.geometry, face);
  const auto target = plane.at(barycentric);
  BackStep best;
  for (Index source : state.sources_in(face)) {
    const double distance = state.sources[source].offset +
                            distance_in_plane(plane.at(source_in_face(state, source, face)), target);
    if (!(distance < best.distance)) continue;
    best = {.distance = distance, .source = source};
    if (state.directions != nullptr) best.first_leg = state.directions->angle_in_face(face, barycentric);
  }
  for (int i = 0; i < 3; ++i) {
    const Index v = state.mesh.face_vertices(face)[i];
    if (barycentric[i] == 1.0 || avoided.contains(v)) continue;
    const double distance = state.vertices[v].distance + distance_in_plane(plane.corner[i], target);
    if (!(distance < best.distance)) continue;
    best = {.distance = distance, .vertex = v};
    if (state.directions == nullptr) continue;
    best.first_leg =
        state.is_source(v) ? state.directions->angle_in_face(face, barycentric) : state.vertices[v].first_leg;
  }
  for (int i = 0; i < 3; ++i) {
    if (barycentric[(i + 2) % 3] == 0.0) continue;  // a point on this edge is not reached across it
    const Index h = 3 * face + i;
    const Index edge = state.mesh.edge_of(h);
    const FaceFrame& frame = state.geometry->frame[h];
    const double length = state.mesh.edge_length(edge);
    const bool along = state.mesh.tail(h) == state.geometry->ends(edge)[0];
    const double x = barycentric[along ? (i + 1) % 3 : i] * length + barycentric[(i + 2) % 3] * frame.apex_x;
    const double depth = barycentric[(i + 2) % 3] * frame.apex_depth;
    for (const Window& window : state.envelope.windows(edge)) {
      if (window.entry() == h) continue;
      const double height = window.source_y + depth;
      const double straight =
          height > 0.0 ? window.source_x + (x - window.source_x) * (window.source_y / height) : x;
      const double at = std::clamp(straight, window.begin, window.end);
      const double distance = window.distance(at) + std::hypot(x - at, depth);
      if (!(distance < best.distance)) continue;
      const double scale = state.geometry->scale_at(edge, at, distance, length);
      if (avoided.contains(h, at, same_place * scale)) continue;
      best = {.distance = distance, .halfedge = h, .x = at};
      if (state.directions == nullptr) continue;
      // To a point beside the window, as in the shadow of a vertex at its end, the path turns at that end.
      best.first_leg = at == straight ? FirstLeg::to(window, x, depth) : FirstLeg::to(window, at, 0.0);
    }
  }
  return best;
}

ExactSolver::State::Reached ExactSolver::State::reached_on_edge(const EdgePoint& point) const {
  const auto [a, b] = geometry->ends(point.edge);
  const double length = mesh.edge_length(point.edge);
  const double x = geometry->is_turned(point.edge) ? length - point.position : point.position;
  Reached best{unreachable, no_index};
  auto take = [&](double distance, Index source) {
    if (distance < best.distance) best = {distance, source};
  };
  take(vertices[a].distance + x, vertices[a].source);
  take(vertices[b].distance + (length - x), vertices[b].source);
  for (Index k = 0; k < static_cast<Index>(sources.size()); ++k) {
    const ExactSource& source = sources[k];
    if (source.point.is_vertex()) continue;
    // A source on the edge itself makes no window there.
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * source.point.face + i;
      if (mesh.edge_of(h) != point.edge || source.point.barycentric[(i + 2) % 3] != 0.0) continue;
      const double at = length * source.point.barycentric[mesh.tail(h) == a ? (i + 1) % 3 : i];
      take(source.offset + std::abs(x - at), k);
    }
  }
  // The window at the point; in a gap left by rounding, those on both sides of it.
  const auto list = envelope.windows(point.edge);
  const auto next = std::ranges::upper_bound(list, x, {}, &Window::begin);
  auto look = [&](const Window& window) {
    const double at = std::clamp(x, window.begin, window.end);
    take(window.distance(at) + std::abs(x - at), window.source);
  };
  if (next != list.end()) look(*next);
  if (next != list.begin()) look(*(next - 1));
  return best;
}

namespace {

/// The last step of a path to a point; beyond the greatest distance of the run, a step from nowhere.
BackStep last_step(const ExactSolver::State& state, const SurfacePoint& target) {
  state.require_windows();
  BackStep best;
  for_each_face_at(state.mesh, target, [&](Index face, const std::array<double, 3>& weights) {
    const BackStep step = best_back_step(state, face, weights);
    if (step.distance < best.distance) best = step;
  });
  return best.distance <= state.max_distance ? best : BackStep{};
}

}  // namespace

double ExactSolver::distance(const SurfacePoint& point) const {
  const SurfacePoint target = validated(state_->mesh, point);
  return target.is_vertex() ? distance(target.vertex) : last_step(*state_, target).distance;
}

double ExactSolver::first_leg(const SurfacePoint& point) const {
  const SurfacePoint target = validated(state_->mesh, point);
  return target.is_vertex() ? first_leg(target.vertex) : last_step(*state_, target).first_leg;
}

double ExactSolver::last_leg(const TangentFrame& frame) const {
  state_->require_windows();
  const SurfacePoint& point = frame.point();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (point.is_vertex() && (distance(point.vertex) == unreachable || state_->is_source(point.vertex)))
    return none;
  BackStep best;
  Index through = no_index;
  for_each_face_at(state_->mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    const BackStep step = best_back_step(*state_, face, weights);
    if (!(step.distance < best.distance)) return;
    best = step;
    through = face;
  });
  if (!(best.distance <= state_->max_distance)) return none;
  if (best.halfedge != no_index) return frame.view(best.halfedge).angle_to(best.x);
  if (best.vertex != no_index) return frame.angle_to(through, best.vertex);
  if (is_same_point(state_->mesh, state_->sources[best.source].point, point)) return none;
  return frame.angle_in_face(through, source_in_face(*state_, best.source, through));
}

// ---- Paths back to the source, one face at a time, through the windows that a run left

namespace {

/// Crossings this close to the end of an edge pass through the vertex: relative to the length of the edge,
/// and to that of the path.
constexpr double snap = 1e-10;
constexpr double snap_of_path = 1e-13;

/// How much longer than the distance a traced path may be: relative to it, and by the rounding of a distance
/// in a face, in mean edge lengths (which may be many times a path in a small part of the mesh).
struct Slack {
  double relative;
  double mean_edges;
};
/// First ordinary rounding, then that of long edges and of nearly degenerate faces, finally any amount, so
/// that there is a path.
constexpr Slack slacks[] = {
    {0.5 * path_tolerance, 0.0}, {0.5 * path_tolerance, 1e-14}, {1e-6, 1e-14}, {unreachable, 0.0}};

/// Walks from a target back to its source: a depth-first search over the vertices and crossings of edges, the
/// best step first. Nearly always the best steps alone lead there. But among edges of no length and faces
/// of no area many paths are equally long, and some are dead ends.
class Tracer {
 public:
  Tracer(const ExactSolver::State& state, const SurfacePoint& target, double distance, const Slack& slack,
         bool only_leg)
      : state_(state),
        mesh_(state.mesh),
        only_leg_(only_leg),
        distance_(distance),
        bound_(distance * (1.0 + slack.relative) + slack.mean_edges * state.mesh.mean_edge_length()) {
    stops_.push_back({target, no_index, 0.0});
    if (target.is_vertex()) passed_.insert(target.vertex);
  }

  /// The path; without points if there is none within the bound.
  SurfacePath trace() {
    // A round passes a vertex or a place on an edge, or goes back by one stop. Few edges are crossed twice; a
    // crossing that rounding shifts each time would be repeated without end.
    const std::size_t most_rounds = 2 * (static_cast<std::size_t>(mesh_.vertex_count()) + mesh_.edge_count());
    for (std::size_t round = 1; !has_arrived(); ++round) {
      if (round % 256 == 0) checkpoint();
      if (!go_on()) stops_.pop_back();
      if (stops_.empty() || round > most_rounds) return {};
    }
    SurfacePath path;
    path.length = stops_.back().walked;
    path.points.reserve(stops_.size());
    for (const Stop& stop : stops_) path.points.push_back(stop.point);
    return path;
  }

 private:
  struct Stop {
    SurfacePoint point;
    Index entered;  ///< the face just crossed
    double walked;  ///< from the target
  };

  bool has_arrived() const {
    const SurfacePoint& here = stops_.back().point;
    return arrived_ || is_source(here) || (only_leg_ && here.is_vertex() && stops_.size() > 1);
  }
  bool is_source(const SurfacePoint& point) const {
    if (!point.is_vertex()) return false;
    const VertexState& vertex = state_.vertices[point.vertex];
    return vertex.source != no_index && vertex.along_edge_from == no_index &&
           state_.sources[vertex.source].point.vertex == point.vertex &&
           state_.sources[vertex.source].offset <= vertex.distance;
  }

  /// Takes the best step that passes nothing already passed. \return false if there is none.
  bool go_on() {
    const Stop here = stops_.back();
    if (here.point.is_vertex() && go_along_edge(here)) return true;
    BackStep best;
    Index best_face = no_index;
    std::array<double, 3> best_here{};
    for_each_face_at(mesh_, here.point, [&](Index face, const std::array<double, 3>& barycentric) {
      if (face == here.entered && !here.point.is_vertex()) return;
      if (!state_.may_enter(face) && stops_.size() > 1 && !state_.face_sources.contains(face)) return;
      const BackStep back = best_back_step(state_, face, barycentric, passed_);
      if (back.distance < best.distance) {
        best = back;
        best_face = face;
        best_here = barycentric;
      }
    });
    if (best_face == no_index || here.walked + best.distance > bound_) {
      if (!stay_in_place(here, best, best_face, best_here)) return false;
    }
    std::array<double, 3> there{};
    if (best.source != no_index) {
      there = source_in_face(state_, best.source, best_face);
      arrived_ = true;
    } else if (best.vertex != no_index) {
      for (int i = 0; i < 3; ++i) there[i] = mesh_.face_vertices(best_face)[i] == best.vertex ? 1.0 : 0.0;
    } else {
      there = crossing(best);
    }
    SurfacePoint point = SurfacePoint::in_face(best_face, there);
    for (int i = 0; i < 3; ++i) {
      if (there[(i + 1) % 3] == 0.0 && there[(i + 2) % 3] == 0.0)
        point = SurfacePoint::at_vertex(mesh_.face_vertices(best_face)[i]);
    }
    if (best.halfedge != no_index) passed_.insert(best.halfedge, best.x);
    // The crossing was moved to an end of its edge that had been passed before: the next round avoids this
    // place.
    if (point.is_vertex() && !passed_.insert(point.vertex) && !arrived_) return true;
    const FacePlane plane(*state_.geometry, best_face);
    const auto from = plane.at(best_here);
    const auto to = plane.at(there);
    stops_.push_back({point, best_face, here.walked + std::hypot(to[0] - from[0], to[1] - from[1])});
    return true;
  }

  /// A step of no length onto another edge of a face without width. Rays of a vertex that lies on an edge
  /// pass a heap of such faces as windows of no length, which no edge keeps: from there, the way back leads
  /// through the same place. \return false if there is none.
  bool stay_in_place(const Stop& here, BackStep& step, Index& step_face,
                     std::array<double, 3>& step_here) const {
    bool found = false;
    for_each_face_at(mesh_, here.point, [&](Index face, const std::array<double, 3>& barycentric) {
      if (!state_.may_enter(face)) return;
      for (int i = 0; i < 3 && !found; ++i) {
        const double at_apex = barycentric[(i + 2) % 3];
        const Index h = 3 * face + i;
        const Index edge = mesh_.edge_of(h);
        const FaceFrame& frame = state_.geometry->frame[h];
        const double length = mesh_.edge_length(edge);
        const bool along = mesh_.tail(h) == state_.geometry->ends(edge)[0];
        const double x = barycentric[along ? (i + 1) % 3 : i] * length + at_apex * frame.apex_x;
        const double rounding = same_place * state_.geometry->scale_at(edge, x, distance_, length);
        const bool is_on_edge = at_apex * frame.apex_depth <= rounding && x >= 0.0 && x <= length;
        if (at_apex == 0.0 || !(length > 0.0) || !is_on_edge) continue;
        if (passed_.contains(h, x, rounding)) continue;
        found = true;
        step = {distance_ - here.walked, no_index, no_index, h, x};
        step_face = face;
        step_here = barycentric;
      }
    });
    return found;
  }

  /// Where a step leaves its face.
  std::array<double, 3> crossing(const BackStep& step) const {
    const Index h = step.halfedge;
    const double length = mesh_.edge_length(mesh_.edge_of(h));
    const double at_end = std::min(snap * length, snap_of_path * distance_);
    // The weight of the far end of a long edge may be tiny: it would be lost in a difference.
    double second = length > 0.0 ? step.x / length : 0.0;
    if (step.x <= at_end) second = 0.0;
    if (length - step.x <= at_end) second = 1.0;
    const bool along = mesh_.tail(h) == state_.geometry->ends(mesh_.edge_of(h))[0];
    std::array<double, 3> there{};
    there[h % 3] = along ? 1.0 - second : second;
    there[Mesh::next_in_face(h) % 3] = along ? second : 1.0 - second;
    return there;
  }

  /// Goes to the vertex from which this one was reached, if it was reached along an edge.
  bool go_along_edge(const Stop& here) {
    const Index from = state_.vertices[here.point.vertex].along_edge_from;
    if (from == no_index || passed_.contains(from)) return false;
    for (Index corner : mesh_.corners(here.point.vertex)) {
      for (Index side : {corner, Mesh::previous_in_face(corner)}) {
        if (mesh_.tail(side) != from && mesh_.head(side) != from) continue;
        const double length = mesh_.edge_length(mesh_.edge_of(side));
        if (here.walked + length + state_.vertices[from].distance > bound_) return false;
        passed_.insert(from);
        stops_.push_back({SurfacePoint::at_vertex(from), no_index, here.walked + length});
        return true;
      }
    }
    return false;
  }

  const ExactSolver::State& state_;
  const Mesh& mesh_;
  bool only_leg_;
  double distance_;
  double bound_;
  std::vector<Stop> stops_;
  PassedPlaces passed_;
  bool arrived_ = false;
};

}  // namespace

SurfacePath ExactSolver::path_to_source(const SurfacePoint& target, bool only_leg) const {
  const SurfacePoint start = validated(state_->mesh, target);
  state_->require_windows();
  const double total = distance(start);
  if (total == unreachable) return {};
  for (const Slack& slack : slacks) {
    SurfacePath path = Tracer(*state_, start, total, slack, only_leg).trace();
    if (!path.points.empty()) return path;
  }
  return {};
}

}  // namespace vorogeo
