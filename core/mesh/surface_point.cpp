// Points of the surface, lists of them, and distances between points of one face.
#include "mesh/surface_point.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "mesh/vectors.h"
#include "support/error.h"

namespace vorogeo {

// ---- Validation and position of surface points

namespace {

/// Tolerance of weights and of their sum: single precision, in which many programs store them, errs by up to
/// 2e-7.
constexpr double weight_tolerance = 1e-6;

/// Weights up to this are rounding of 0: the point lies on the edge or in the corner.
constexpr double weight_rounding = 1e-14;

}  // namespace

SurfacePoint validated(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) {
    if (point.vertex < 0 || point.vertex >= mesh.vertex_count()) {
      throw InvalidInput("Vertex " + std::to_string(point.vertex) + " does not exist: the mesh has " +
                         vertex_range(mesh.vertex_count()) + ".");
    }
    return SurfacePoint::at_vertex(mesh.representative(point.vertex));
  }
  if (point.face == no_index) throw InvalidInput("A surface point needs a vertex or a face.");
  if (point.face < 0 || point.face >= mesh.face_count()) {
    throw InvalidInput("Face " + std::to_string(point.face) + " does not exist: the mesh has faces 0 to " +
                       std::to_string(mesh.face_count() - 1) + ".");
  }
  auto refuse = [&](const std::string& what) {
    std::ostringstream message;
    message.precision(9);
    message << "The point in face " << mesh.input_face(point.face) << " has barycentric weights "
            << point.barycentric[0] << ", " << point.barycentric[1] << ", " << point.barycentric[2] << ", "
            << what << "; give weights of at least 0 with the sum 1 (both to within " << weight_tolerance
            << ").";
    throw InvalidInput(message.str());
  };
  double sum = 0.0;
  for (double weight : point.barycentric) {
    if (!(weight >= -weight_tolerance && weight <= 1.0 + weight_tolerance))
      refuse("one of them outside [0, 1]");
    sum += weight;
  }
  if (!(std::abs(sum - 1.0) <= weight_tolerance)) refuse("which do not sum to 1");
  SurfacePoint result = point;
  double total = 0.0;
  for (double& weight : result.barycentric) total += weight = weight > weight_rounding ? weight : 0.0;
  for (int i = 0; i < 3; ++i) {
    result.barycentric[i] /= total;
    if (result.barycentric[i] == 1.0) return SurfacePoint::at_vertex(mesh.face_vertices(point.face)[i]);
  }
  return result;
}

SurfacePoint canonical(const Mesh& mesh, const SurfacePoint& point) {
  SurfacePoint first = point;
  if (point.is_vertex()) return first;
  for_each_face_at(mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    if (face < first.face) first = SurfacePoint::in_face(face, weights);
  });
  return first;
}

SurfacePoint point_on_edge(const Mesh& mesh, Index edge, double fraction) {
  if (fraction <= 0.0) return SurfacePoint::at_vertex(mesh.edge_vertices(edge)[0]);
  if (fraction >= 1.0) return SurfacePoint::at_vertex(mesh.edge_vertices(edge)[1]);
  const Index h = mesh.edge_halfedge(edge);
  const bool along = mesh.tail(h) == mesh.edge_vertices(edge)[0];
  std::array<double, 3> weights{};
  weights[h % 3] = along ? 1.0 - fraction : fraction;
  weights[Mesh::next_in_face(h) % 3] = along ? fraction : 1.0 - fraction;
  return SurfacePoint::in_face(Mesh::face_of(h), weights);
}

std::array<double, 3> distances_in_face(const Mesh& mesh, const SurfacePoint& point) {
  const auto corners = mesh.face_corners(point.face);
  Point at{};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) at[k] += point.barycentric[i] * corners[i][k];
  }
  std::array<double, 3> distances{};
  for (int i = 0; i < 3; ++i) distances[i] = distance_between(at, corners[i]);
  return distances;
}

Point position_of(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) return mesh.position(point.vertex);
  Point result{};
  for (int i = 0; i < 3; ++i) {
    const Point& corner = mesh.position(mesh.face_vertices(point.face)[i]);
    for (int k = 0; k < 3; ++k) result[k] += point.barycentric[i] * corner[k];
  }
  return result;
}

std::vector<Point> positions_of(const Mesh& mesh, std::span<const SurfacePoint> points) {
  std::vector<Point> positions;
  for (const SurfacePoint& point : points) positions.push_back(position_of(mesh, point));
  return positions;
}

double potential_at(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) return mesh.potential(point.vertex);
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    sum += point.barycentric[i] * mesh.potential(mesh.face_vertices(point.face)[i]);
  }
  return sum;
}

bool weights_in_face(const Mesh& mesh, const SurfacePoint& point, Index face,
                     std::array<double, 3>& weights) {
  weights = {};
  if (!point.is_vertex() && point.face == face) {
    weights = point.barycentric;
    return true;
  }
  double weight_at_vertex = 0.0;
  for (int k = 0; k < 3; ++k) {
    const Index v = mesh.face_vertices(face)[k];
    if (point.is_vertex()) {
      weights[k] = v == point.vertex ? 1.0 : 0.0;
      weight_at_vertex += weights[k];
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      if (mesh.face_vertices(point.face)[i] == v) weights[k] = point.barycentric[i];
    }
  }
  if (point.is_vertex()) return weight_at_vertex > 0.0;
  for (int i = 0; i < 3; ++i) {
    if (point.barycentric[i] == 0.0) continue;
    const Index v = mesh.face_vertices(point.face)[i];
    const auto& there = mesh.face_vertices(face);
    if (there[0] != v && there[1] != v && there[2] != v) return false;
  }
  return true;
}

// ---- Checks of point lists

bool PointList::only_vertices() const {
  return std::ranges::all_of(points_, [](const SurfacePoint& point) { return point.is_vertex(); });
}

std::vector<Index> PointList::vertices() const {
  std::vector<Index> result;
  result.reserve(points_.size());
  for (const SurfacePoint& point : points_) result.push_back(point.vertex);
  return result;
}

PointList points_on(const Mesh& mesh, const PointList& points, const char* role) {
  std::vector<SurfacePoint> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& point = points[i];
    const std::string name = std::string(role) + " " + std::to_string(i);
    if (point.face == no_index && (point.vertex < 0 || point.vertex >= mesh.vertex_count())) {
      throw InvalidInput(name + " is vertex " + std::to_string(point.vertex) +
                         ", which does not exist: the mesh has " + vertex_range(mesh.vertex_count()) + ".");
    }
    try {
      result.push_back(canonical(mesh, validated(mesh, point)));
    } catch (const InvalidInput& error) {
      throw InvalidInput(name + " is not on the mesh. " + error.what());
    }
  }
  return result;
}

// ---- The face in the plane: paths through its corners, and paths unfolded over its edges

std::array<double, 3> distances_in_triangle(const std::array<double, 3>& length,
                                            const std::array<double, 3>& weights) {
  std::array<double, 3> to_corner{};
  for (int i = 0; i < 3; ++i) {
    const double next = weights[(i + 1) % 3];
    const double previous = weights[(i + 2) % 3];
    const double a = length[i] * length[i];
    const double b = length[(i + 2) % 3] * length[(i + 2) % 3];
    const double opposite = length[(i + 1) % 3] * length[(i + 1) % 3];
    const double square = next * next * a + previous * previous * b + next * previous * (a + b - opposite);
    to_corner[i] = std::sqrt(std::fmax(0.0, square));
  }
  return to_corner;
}

double distance_in_triangle(const std::array<double, 3>& length, const std::array<double, 3>& weights,
                            const std::array<double, 3>& corner_distance) {
  const std::array<double, 3> to_corner = distances_in_triangle(length, weights);
  double best = unreachable;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    best = std::min(best, corner_distance[i] + to_corner[i]);
    if (!(corner_distance[i] < unreachable && corner_distance[j] < unreachable)) continue;
    double through =
        unfolded_distance(length[i], corner_distance[i], corner_distance[j], to_corner[i], to_corner[j]);
    const double third =
        unfolded_distance(length[i], corner_distance[i], corner_distance[j], length[k], length[j]);
    if (third < corner_distance[k] && corner_distance[k] < unreachable) {
      through += weights[k] * (corner_distance[k] - third);
    }
    best = std::min(best, through);
  }
  return best;
}

}  // namespace vorogeo
