// Distances at any surface point and paths back to the source, read off the envelope that a run left.
#include <algorithm>
#include <cmath>

#include "exact/exact_solver.h"
#include "exact/solver_state.h"
#include "support/error.h"

namespace vorogeo {

namespace {

/// A step back that gains less than this (relative) is a rounding error, not progress.
constexpr double least_gain = 1e-14;
/// Crossings this close to an edge's end (relative to its length) pass through the vertex.
constexpr double snap = 1e-10;

double distance_in_plane(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

}  // namespace

FacePlane::FacePlane(const ExactGeometry& geometry, Index face) {
  const Mesh& mesh = *geometry.mesh;
  const FaceFrame& frame = geometry.frame[3 * face];
  const Index edge = mesh.edge_of(3 * face);
  const double length = mesh.edge_length(edge);
  const bool along = mesh.edge_vertices(edge)[0] == mesh.face_vertices(face)[0];
  corner[0] = {0.0, 0.0};
  corner[1] = {length, 0.0};
  corner[2] = {along ? frame.apex_x : length - frame.apex_x, frame.apex_depth};
}

std::array<double, 2> FacePlane::at(const std::array<double, 3>& barycentric) const {
  std::array<double, 2> point{};
  for (int i = 0; i < 3; ++i) {
    point[0] += barycentric[i] * corner[i][0];
    point[1] += barycentric[i] * corner[i][1];
  }
  return point;
}

void ExactSolver::State::look_at_target() {
  const auto [a, b] = mesh.edge_vertices(open);
  const Point& p = mesh.position(a);
  const Point& q = mesh.position(b);
  const double scale = open_length > 0.0 ? 1.0 / open_length : 0.0;
  target_x = 0.0;
  for (int i = 0; i < 3; ++i) target_x += (corridor_at[i] - p[i]) * (q[i] - p[i]) * scale;
  double square = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double aside = corridor_at[i] - p[i] - target_x * ((q[i] - p[i]) * scale);
    square += aside * aside;
  }
  target_depth = std::sqrt(square);
  if (landmarks == nullptr) return;
  proven_at_first = landmarks->least_distance(a, target_seen);
  proven_at_second = landmarks->least_distance(b, target_seen);
}

double ExactSolver::State::length_through(const Window& window) const {
  // The target turned about the edge into the plane, on the other side than the source: the straight way
  // between the two crosses the edge where the sum of both distances is least.
  const double height = window.source_y + target_depth;
  const double across = height > 0.0
                            ? window.source_x + (target_x - window.source_x) * (window.source_y / height)
                            : window.source_x;
  const double at = std::clamp(across, window.begin, window.end);
  const double dx = at - target_x;
  const double straight = window.distance(at) + std::sqrt(dx * dx + target_depth * target_depth);
  const double length = open_length;
  if (landmarks != nullptr) {
    // The bounds of both ends, less the way to them, cross where the larger one is least; window distances
    // change no faster.
    const double x =
        std::clamp(0.5 * (proven_at_first - proven_at_second + length), window.begin, window.end);
    return std::max(straight,
                    window.distance(x) + std::max(proven_at_first - x, proven_at_second - (length - x)));
  }
  if (least_remaining.empty()) return straight;
  const auto [a, b] = mesh.edge_vertices(open);
  const double from_a = least_remaining[a];
  const double from_b = least_remaining[b];
  const double nearest = std::min(from_a, from_b);
  if (!(std::max(from_a, from_b) < unreachable)) {
    return std::max(straight, window.least_distance() + nearest - length);
  }
  // Between its ends the distance to the target may sag below the chord, as far as a circle around a point so
  // near.
  const double sag = nearest > length ? 0.125 * length * length / (nearest - 0.5 * length) : 0.5 * length;
  const double slope = std::clamp((from_b - from_a) / length, -1.0, 1.0);
  // The sum of the window's distance and the chord is least where both change alike.
  const double steepness = std::sqrt(1.0 - slope * slope);
  const double level = steepness > 0.0 ? window.source_x - slope * window.source_y / steepness
                                       : (slope > 0.0 ? window.begin : window.end);
  const double x = std::clamp(level, window.begin, window.end);
  const double chord = std::min(from_a + slope * x, from_b - slope * (length - x));
  return std::max(straight, window.distance(x) + chord - sag);
}

std::vector<Index> ExactSolver::State::sources_in(Index face) const {
  std::vector<Index> found;
  const auto [begin, end] = face_sources.equal_range(face);
  for (auto it = begin; it != end; ++it) found.push_back(it->second);
  return found;
}

namespace {

/// Barycentric coordinates in `face` of a source that lies in it or on one of its edges.
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

}  // namespace

BackStep best_way(const ExactSolver::State& state, Index face, const std::array<double, 3>& barycentric,
                  std::span<const Index> avoided) {
  auto is_avoided = [&](Index item) { return std::ranges::find(avoided, item) != avoided.end(); };
  const FacePlane plane(*state.geometry, face);
  const auto target = plane.at(barycentric);
  BackStep best;
  for (Index source : state.sources_in(face)) {
    const double distance = state.sources[source].offset +
                            distance_in_plane(plane.at(source_in_face(state, source, face)), target);
    if (distance < best.distance) best = {distance, source, no_index, no_index, 0.0};
  }
  for (int i = 0; i < 3; ++i) {
    const Index v = state.mesh.face_vertices(face)[i];
    if (barycentric[i] == 1.0 || is_avoided(v)) continue;
    const double distance = state.vertices[v].distance + distance_in_plane(plane.corner[i], target);
    if (distance < best.distance) best = {distance, no_index, v, no_index, 0.0};
  }
  for (int i = 0; i < 3; ++i) {
    if (barycentric[(i + 2) % 3] == 0.0) continue;  // a point on this edge does not come across it
    const Index h = 3 * face + i;
    const Index edge = state.mesh.edge_of(h);
    if (is_avoided(state.mesh.vertex_count() + edge)) continue;
    const FaceFrame& frame = state.geometry->frame[h];
    const double length = state.mesh.edge_length(edge);
    const bool along = state.mesh.tail(h) == state.mesh.edge_vertices(edge)[0];
    const double x = barycentric[along ? (i + 1) % 3 : i] * length + barycentric[(i + 2) % 3] * frame.apex_x;
    const double depth = barycentric[(i + 2) % 3] * frame.apex_depth;
    for (const Window& window : state.envelope.windows(edge)) {
      if (window.entry() == h) continue;
      const double height = window.source_y + depth;
      const double straight =
          height > 0.0 ? window.source_x + (x - window.source_x) * (window.source_y / height) : x;
      const double at = std::clamp(straight, window.begin, window.end);
      const double distance = window.distance(at) + std::hypot(x - at, depth);
      if (distance < best.distance) best = {distance, no_index, no_index, h, at};
    }
  }
  return best;
}

double ExactSolver::distance(const SurfacePoint& point) const {
  const SurfacePoint target = validated(state_->mesh, point);
  if (target.is_vertex()) return distance(target.vertex);
  state_->require_windows();
  double found = unreachable;
  for_each_face_at(state_->mesh, target, [&](Index face, const std::array<double, 3>& weights) {
    found = std::min(found, best_way(*state_, face, weights).distance);
  });
  return found <= state_->max_distance ? found : unreachable;
}

namespace {

/// Walks from a target back to its source, one face at a time.
class Tracer {
 public:
  explicit Tracer(const ExactSolver::State& state) : state_(state), mesh_(state.mesh) {}

  SurfacePath trace(SurfacePoint target, double distance) {
    path_.points.push_back(target);
    left_ = distance;
    // Each step lowers the distance or follows the finite chain of edges, so this ends.
    while (step()) {
    }
    return std::move(path_);
  }

 private:
  bool step() {
    const SurfacePoint here = path_.points.back();
    if (here.is_vertex()) {
      const VertexState& vertex = state_.vertices[here.vertex];
      if (vertex.source != no_index && state_.sources[vertex.source].point.vertex == here.vertex &&
          state_.sources[vertex.source].offset >= vertex.distance * (1.0 - least_gain)) {
        return false;
      }
      if (vertex.along_edge_from != no_index) {
        go_to(SurfacePoint::at_vertex(vertex.along_edge_from), vertex.along_edge_from, here.vertex);
        return true;
      }
    }
    BackStep best;
    Index best_face = no_index;
    std::array<double, 3> best_here{};
    for_each_face_at(mesh_, here, [&](Index face, const std::array<double, 3>& barycentric) {
      if (face == entered_ && !here.is_vertex()) return;  // the one just crossed
      const BackStep way = best_way(state_, face, barycentric, stood_);
      if (way.distance < best.distance) {
        best = way;
        best_face = face;
        best_here = barycentric;
      }
    });
    if (best_face == no_index) return false;
    const FacePlane plane(*state_.geometry, best_face);
    const auto from = plane.at(best_here);
    std::array<double, 3> there{};
    bool arrived = false;
    if (best.source != no_index) {
      there = source_in_face(state_, best.source, best_face);
      arrived = true;
    } else if (best.vertex != no_index) {
      for (int i = 0; i < 3; ++i) there[i] = mesh_.face_vertices(best_face)[i] == best.vertex ? 1.0 : 0.0;
    } else {
      const Index h = best.halfedge;
      const double length = mesh_.edge_length(mesh_.edge_of(h));
      double t = length > 0.0 ? best.x / length : 0.0;
      if (t < snap) t = 0.0;
      if (t > 1.0 - snap) t = 1.0;
      if (mesh_.tail(h) != mesh_.edge_vertices(mesh_.edge_of(h))[0]) t = 1.0 - t;
      there[h % 3] = 1.0 - t;
      there[Mesh::next_in_face(h) % 3] = t;
    }
    const double walked = distance_in_plane(from, plane.at(there));
    const double before = left_;
    // Steps of no length, through faces of no area, must not lead back to where the path has been.
    if (walked > least_gain * path_.length) stood_.clear();
    if (best.vertex != no_index) {
      stood_.push_back(best.vertex);
    } else if (best.halfedge != no_index) {
      stood_.push_back(mesh_.vertex_count() + mesh_.edge_of(best.halfedge));
    }
    left_ -= walked;
    path_.length += walked;
    path_.points.push_back(validated(mesh_, SurfacePoint::in_face(best_face, there)));
    entered_ = best_face;
    return !arrived && left_ < before * (1.0 + least_gain) && path_.points.size() < limit();
  }

  void go_to(const SurfacePoint& point, Index a, Index b) {
    for (Index corner : mesh_.corners(b)) {
      for (Index side : {corner, Mesh::previous_in_face(corner)}) {
        if ((mesh_.tail(side) == b ? mesh_.head(side) : mesh_.tail(side)) == a) {
          const double length = mesh_.edge_length(mesh_.edge_of(side));
          path_.length += length;
          left_ -= length;
          path_.points.push_back(point);
          entered_ = no_index;
          return;
        }
      }
    }
  }

  std::size_t limit() const { return 4 * static_cast<std::size_t>(mesh_.face_count()) + 16; }

  const ExactSolver::State& state_;
  const Mesh& mesh_;
  SurfacePath path_;
  double left_ = 0.0;
  Index entered_ = no_index;
  std::vector<Index> stood_;  ///< vertices and edges passed without getting on
};

}  // namespace

SurfacePath ExactSolver::path_to_source(const SurfacePoint& target) const {
  const SurfacePoint start = validated(state_->mesh, target);
  state_->require_windows();
  const double total = distance(start);
  if (total == unreachable) return {};
  return Tracer(*state_).trace(start, total);
}

}  // namespace vorogeo
