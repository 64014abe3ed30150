// Barycentric weights of work vertices in faces of the user's mesh, and their inverse.
#include "index/work_points.h"

#include <algorithm>

#include "support/prefetch.h"

namespace vorogeo {

namespace {

using Weights = std::array<double, 3>;

/// Weights below this are rounding.
constexpr double least_weight = 1e-13;

Weights cleaned(Weights weights) {
  double sum = 0.0;
  for (double& w : weights) {
    if (w < least_weight) w = 0.0;
    sum += w;
  }
  for (double& w : weights) w /= sum;
  return weights;
}

/// Weights of a work vertex in a face of the user's mesh that holds it: a corner or a point on an edge.
Weights weights_of(const IndexData& data, Index work_vertex, Index user_face) {
  Weights weights{};
  const auto& corners = data.mesh->face_vertices(user_face);
  const Index user = data.work.user_vertex[work_vertex];
  if (user != no_index) {
    for (int i = 0; i < 3; ++i) weights[i] = corners[i] == user ? 1.0 : 0.0;
    return weights;
  }
  const auto& points = data.work.edge_points;
  const auto at = std::lower_bound(points.begin(), points.end(), work_vertex,
                                   [](const auto& point, Index vertex) { return point.vertex < vertex; });
  const auto [a, b] = data.mesh->edge_vertices(at->user_edge);
  for (int i = 0; i < 3; ++i) {
    if (corners[i] == a) weights[i] = 1.0 - at->position;
    if (corners[i] == b) weights[i] = at->position;
  }
  return weights;
}

/// Work faces of a face of the user: first and one past the last.
std::array<Index, 2> work_faces(const IndexData& data, Index user_face) {
  const auto& label = data.work.second_layer;
  const auto& user = data.work.user_face;
  const Index patch = data.partition.second_layer[user_face];
  const auto begin = std::lower_bound(label.begin(), label.end(), patch) - label.begin();
  const auto end = std::upper_bound(label.begin() + begin, label.end(), patch) - label.begin();
  const auto first = std::lower_bound(user.begin() + begin, user.begin() + end, user_face) - user.begin();
  const auto last = std::upper_bound(user.begin() + first, user.begin() + end, user_face) - user.begin();
  return {static_cast<Index>(first), static_cast<Index>(last)};
}

/// Weights (a, b, c) with a A + b B + c C = P, all of them weights in one face.
Weights solve(const std::array<Weights, 3>& corner, const Weights& point) {
  auto area = [](const Weights& a, const Weights& b, const Weights& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const double whole = area(corner[0], corner[1], corner[2]);
  if (whole == 0.0) return {-1.0, -1.0, -1.0};
  return {area(point, corner[1], corner[2]) / whole, area(corner[0], point, corner[2]) / whole,
          area(corner[0], corner[1], point) / whole};
}

}  // namespace

SurfacePoint work_point(const IndexData& data, const SurfacePoint& point) {
  if (point.is_vertex()) return SurfacePoint::at_vertex(data.work.work_vertex[point.vertex]);
  const auto [first, last] = work_faces(data, point.face);
  SurfacePoint best;
  double deepest = -unreachable;
  for (Index f = first; f < last; ++f) {
    std::array<Weights, 3> corner{};
    for (int i = 0; i < 3; ++i) {
      corner[i] = weights_of(data, data.work.mesh->face_vertices(f)[i], point.face);
    }
    const Weights weights = solve(corner, point.barycentric);
    const double depth = *std::min_element(weights.begin(), weights.end());
    if (depth <= deepest) continue;
    deepest = depth;
    best = SurfacePoint::in_face(f, weights);
  }
  best.barycentric = cleaned(best.barycentric);
  return validated(*data.work.mesh, best);
}

SurfacePoint user_point(const IndexData& data, const SurfacePoint& point) {
  Index face = point.face;
  if (point.is_vertex()) {
    const Index user = data.work.user_vertex[point.vertex];
    if (user != no_index) return SurfacePoint::at_vertex(user);
    face = Mesh::face_of(data.work.mesh->corners(point.vertex).front());
  }
  const Index user_face = data.work.user_face[face];
  Weights weights{};
  if (point.is_vertex()) {
    weights = weights_of(data, point.vertex, user_face);
  } else {
    for (int i = 0; i < 3; ++i) {
      if (point.barycentric[i] == 0.0) continue;
      const Weights corner = weights_of(data, data.work.mesh->face_vertices(face)[i], user_face);
      for (int k = 0; k < 3; ++k) weights[k] += point.barycentric[i] * corner[k];
    }
  }
  return validated(*data.mesh, SurfacePoint::in_face(user_face, cleaned(weights)));
}

SurfacePath user_path(const IndexData& data, const SurfacePath& path) {
  // Each of the user's faces is a cache miss.
  for (const SurfacePoint& point : path.points) {
    if (point.is_vertex()) continue;
    prefetch_line(&data.work.user_face[point.face]);
    for (Index vertex : data.work.mesh->face_vertices(point.face)) {
      prefetch_line(&data.work.user_vertex[vertex]);
    }
  }
  for (const SurfacePoint& point : path.points) {
    if (!point.is_vertex()) prefetch_line(&data.mesh->face_vertices(data.work.user_face[point.face]));
  }
  SurfacePath result;
  result.length = path.length;
  result.points.reserve(path.points.size());
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const SurfacePoint point = user_point(data, path.points[i]);
    const bool inside =
        !point.is_vertex() && std::ranges::all_of(point.barycentric, [](double w) { return w > 0.0; });
    if (inside && i > 0 && i + 1 < path.points.size()) continue;
    if (!result.points.empty() && point.is_vertex() && result.points.back().vertex == point.vertex) continue;
    result.points.push_back(point);
  }
  return result;
}

}  // namespace vorogeo
