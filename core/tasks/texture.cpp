// Texture coordinates of a disk around a point.
#include "tasks/texture.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh_input.h"
#include "mesh/vectors.h"

namespace vorogeo {

namespace {

/// For faces without coordinates.
constexpr std::array<double, 2> no_stretch{std::numeric_limits<double>::quiet_NaN(),
                                           std::numeric_limits<double>::quiet_NaN()};

void require_above_0(double value, const char* what) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InvalidInput(std::string(what) + " is " + std::to_string(value) +
                     "; it must be a finite number above 0.");
}

/// The factors by which a picture is stretched when its triangle of the sides `u` and `v` is laid onto a face
/// of the sides `a` and `b`: the singular values of the linear map between them.
std::array<double, 2> stretch_of(const Tangent& u, const Tangent& v, const Point& a, const Point& b) {
  const double determinant = u[0] * v[1] - u[1] * v[0];
  std::array<Point, 2> image{};  // of the unit vectors of the picture
  for (int i = 0; i < 3; ++i) {
    image[0][i] = (v[1] * a[i] - u[1] * b[i]) / determinant;
    image[1][i] = (u[0] * b[i] - v[0] * a[i]) / determinant;
  }
  const double sum = dot(image[0], image[0]) + dot(image[1], image[1]);
  const double area = length_of(cross(image[0], image[1]));
  const double greatest =
      std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, (sum - 2.0 * area) * (sum + 2.0 * area)))));
  return {greatest, area / greatest};
}

}  // namespace

TextureCoordinates texture_coordinates(Surface& surface, const SurfacePoint& point,
                                       const Placement& placement, const TaskOptions& options) {
  const auto& [radius, rotation, scale] = placement;
  require_exact(options, "Texture coordinates are");
  require_above_0(radius, "The radius");
  require_above_0(scale, "The scale");
  if (!std::isfinite(rotation)) {
    throw InvalidInput("The rotation is " + std::to_string(rotation) + "; give a finite number of radians.");
  }
  const std::vector<Tangent> vectors = log_map(surface, point, {}, radius, options).vector;
  std::vector<std::array<double, 2>> coordinates, stretches;
  const double cosine = std::cos(rotation), sine = std::sin(rotation), side = 2.0 * radius * scale;
  for (const auto& [x, y] : vectors) {
    coordinates.push_back({0.5 + (cosine * x + sine * y) / side, 0.5 + (cosine * y - sine * x) / side});
  }
  const Mesh& mesh = *surface.mesh();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.face_vertices(f);
    const auto difference = [&](Index p, Index q) {
      return Tangent{vectors[p][0] - vectors[q][0], vectors[p][1] - vectors[q][1]};
    };
    const auto corner = mesh.face_corners(f);
    const auto stretch = stretch_of(difference(b, a), difference(c, a), minus(corner[1], corner[0]),
                                    minus(corner[2], corner[0]));
    stretches.push_back(std::isfinite(stretch[0]) ? stretch : no_stretch);
  }
  const InputMap map(mesh);
  return {map.of_vertices(std::move(coordinates)), map.of_faces(stretches, no_stretch)};
}

}  // namespace vorogeo
