// The best last segment of a path into a face, and distances at any point of the surface.
#include "exact/back_step.h"

#include <algorithm>
#include <cmath>

namespace vorogeo {

namespace {

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
                        const PassedItems& avoided) {
  auto is_avoided = [&](Index item) { return !avoided.empty() && avoided.contains(item); };
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
    if (barycentric[(i + 2) % 3] == 0.0) continue;  // a point on this edge is not reached across it
    const Index h = 3 * face + i;
    const Index edge = state.mesh.edge_of(h);
    if (is_avoided(state.mesh.vertex_count() + edge)) continue;
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
      if (distance < best.distance) best = {distance, no_index, no_index, h, at};
    }
  }
  return best;
}

double ExactSolver::State::distance_on_edge(const EdgePoint& point) const {
  const auto [a, b] = geometry->ends(point.edge);
  const double length = mesh.edge_length(point.edge);
  const double x = geometry->is_turned(point.edge) ? length - point.position : point.position;
  double found = std::min(vertices[a].distance + x, vertices[b].distance + (length - x));
  for (const ExactSource& source : sources) {
    if (source.point.is_vertex()) continue;
    // A source on the edge itself makes no window there.
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * source.point.face + i;
      if (mesh.edge_of(h) != point.edge || source.point.barycentric[(i + 2) % 3] != 0.0) continue;
      const double at = length * source.point.barycentric[mesh.tail(h) == a ? (i + 1) % 3 : i];
      found = std::min(found, source.offset + std::abs(x - at));
    }
  }
  // The window at the point; in a gap left by rounding, those on both sides of it.
  const auto list = envelope.windows(point.edge);
  const auto next = std::ranges::upper_bound(list, x, {}, &Window::begin);
  auto look = [&](const Window& window) {
    const double at = std::clamp(x, window.begin, window.end);
    found = std::min(found, window.distance(at) + std::abs(x - at));
  };
  if (next != list.end()) look(*next);
  if (next != list.begin()) look(*(next - 1));
  return found;
}

double ExactSolver::distance(const SurfacePoint& point) const {
  const SurfacePoint target = validated(state_->mesh, point);
  if (target.is_vertex()) return distance(target.vertex);
  state_->require_windows();
  double found = unreachable;
  for_each_face_at(state_->mesh, target, [&](Index face, const std::array<double, 3>& weights) {
    found = std::min(found, best_back_step(*state_, face, weights).distance);
  });
  return found <= state_->max_distance ? found : unreachable;
}

}  // namespace vorogeo
