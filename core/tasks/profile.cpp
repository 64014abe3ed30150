// What lies along a path: its length so far, height, slope, curvature and thickness.
#include "tasks/profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "exact/surface_path.h"
#include "mesh/orientation.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "tasks/path_through.h"

namespace vorogeo {

namespace {

/// Whether two faces run along their common edge in opposite directions; true if they share none.
bool are_turned_alike(const Mesh& mesh, Index a, Index b) {
  for (Index h = 3 * a; h < 3 * a + 3; ++h) {
    for (Index g = 3 * b; g < 3 * b + 3; ++g) {
      if (mesh.edge_of(h) == mesh.edge_of(g)) return mesh.tail(h) != mesh.tail(g);
    }
  }
  return true;
}

}  // namespace

Point normal_at(const Mesh& mesh, const SurfacePoint& point) {
  Point sum{};
  Index before = no_index;
  bool is_turned = false;
  for_each_face_at(mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    if (mesh.is_bridge(face)) return;
    // The faces around a vertex come in order, each beside the one before.
    if (before != no_index && !are_turned_alike(mesh, before, face)) is_turned = !is_turned;
    before = face;
    const auto& [a, b, c] = mesh.face_vertices(face);
    const Point& p = mesh.position(a);
    const Point normal = cross(minus(mesh.position(b), p), minus(mesh.position(c), p));
    const double length = length_of(normal);
    if (!(length > 0.0)) return;
    const auto corner = std::ranges::find(weights, 1.0) - weights.begin();
    const double part = corner < 3 ? mesh.corner_angle(3 * face + static_cast<Index>(corner)) : 1.0;
    sum = moved(sum, (is_turned ? -part : part) / length, normal);
  });
  const double length = length_of(sum);
  return length > 0.0 ? moved({}, 1.0 / length, sum) : Point{};
}

Profile profile(const Mesh& mesh, const std::function<const SurfaceLocator&()>& locate, const PointList& path,
                const Point& up, bool turned_over) {
  if (!mesh.has_positions())
    throw InvalidInput("A profile needs the positions of the vertices, not lengths alone.");
  const double size = length_of(up);
  if (!(size > 0.0 && std::isfinite(size))) {
    throw InvalidInput("The direction upwards has length " + std::to_string(size) +
                       "; give one that is finite and not 0.");
  }
  const PointList points = points_on(mesh, path, "Point");
  const SurfaceLocator& locator = locate();
  const std::vector<bool> turned = turned_faces(mesh);
  const auto outwards = [&](const SurfacePoint& point) {
    Index first = no_index;
    for_each_face_at(mesh, point, [&](Index face, const std::array<double, 3>&) {
      if (first == no_index && !mesh.is_bridge(face)) first = face;
    });
    const bool is_turned = first != no_index && turned[first];
    return moved({}, is_turned != turned_over ? -1.0 : 1.0, normal_at(mesh, point));
  };
  /// The normals at a face's corners, interpolated at a point.
  const auto between_corners = [&](Index face, const SurfacePoint& point) {
    std::array<double, 3> weights{};
    weights_in_face(mesh, point, face, weights);
    Point sum{};
    for (int k = 0; k < 3; ++k) {
      if (weights[k] == 0.0) continue;
      sum = moved(sum, weights[k], outwards(SurfacePoint::at_vertex(mesh.face_vertices(face)[k])));
    }
    return sum;
  };
  Profile found;
  std::vector<double> length{0.0}, tilt{0.0};  // of the step to each point
  for (std::size_t i = 0; i < points.size(); ++i) {
    double step = 0.0;
    if (i > 0) step = cost_of_line(mesh, std::array{points[i - 1], points[i]});
    if (!std::isfinite(step)) refuse_step(mesh, points, i);
    found.along.push_back(i > 0 ? found.along.back() + step : 0.0);
    found.height.push_back(dot(position_of(mesh, points[i]), up) / size);
    const Point normal = outwards(points[i]);
    found.angle.push_back(std::acos(std::clamp(dot(normal, up) / size, -1.0, 1.0)));
    found.thickness.push_back(locator.ray_length(points[i], moved({}, -1.0, normal)));
    if (i == 0) continue;
    const Index face = common_face(mesh, points[i - 1], points[i]);
    const Point forwards = minus(position_of(mesh, points[i]), position_of(mesh, points[i - 1]));
    const Point change = minus(between_corners(face, points[i]), between_corners(face, points[i - 1]));
    length.push_back(length_of(forwards));
    tilt.push_back(length.back() > 0.0 ? dot(change, forwards) / length.back() : 0.0);
  }
  length.push_back(0.0);
  tilt.push_back(0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double both = length[i] + length[i + 1];
    found.curvature.push_back(both > 0.0 ? (tilt[i] + tilt[i + 1]) / both : 0.0);
  }
  return found;
}

}  // namespace vorogeo
