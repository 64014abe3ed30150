// Even subdivision of edges and segments.
#include "tasks/curve_sources.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh/mesh_input.h"
#include "support/error.h"
#include "support/lists.h"

namespace vorogeo {

namespace {

constexpr double max_points = 1e7;

}  // namespace

int pieces_of(double length, double spacing) {
  if (!(spacing > 0.0)) {
    throw InvalidInput("The spacing of points along a curve is " + std::to_string(spacing) +
                       "; it must be a length above 0.");
  }
  const double pieces = std::ceil(length / spacing * (1.0 - 1e-12));
  if (pieces > max_points)
    throw InvalidInput("The spacing is too small: it makes more than ten million points.");
  return std::max(1, static_cast<int>(pieces));
}

std::vector<Point> points_between(const Point& a, const Point& b, double spacing) {
  const int pieces = pieces_of(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), spacing);
  std::vector<Point> points;
  for (int k = 1; k < pieces; ++k) {
    const double t = static_cast<double>(k) / pieces;
    points.push_back({std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), std::lerp(a[2], b[2], t)});
  }
  return points;
}

std::vector<Index> edges_of_curve(const Mesh& mesh, std::span<const std::array<int, 2>> ends) {
  std::vector<Index> edges;
  for (const auto& [a, b] : ends) {
    const auto parts = InputMap(mesh).edges_between(mesh.representative(a), mesh.representative(b));
    if (parts.empty()) {
      throw InvalidInput("There is no edge between vertex " + std::to_string(a) + " and vertex " +
                         std::to_string(b) + "; a curve runs along edges of the mesh.");
    }
    edges.insert(edges.end(), parts.begin(), parts.end());
  }
  return edges;
}

std::vector<ExactSource> sources_along_edges(const Mesh& mesh, std::span<const Index> edges, double spacing) {
  std::vector<Index> vertices;
  std::vector<ExactSource> sources;
  double total = 0.0;
  for (Index edge : edges) total += pieces_of(mesh.edge_length(edge), spacing);
  if (total > max_points)
    throw InvalidInput("The spacing is too small: it makes more than ten million points.");
  for (Index edge : edges) {
    const int pieces = pieces_of(mesh.edge_length(edge), spacing);
    const Index h = mesh.edge_halfedge(edge);
    vertices.insert(vertices.end(), {mesh.tail(h), mesh.head(h)});
    for (int k = 1; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      std::array<double, 3> weights{};
      weights[h % 3] = 1.0 - t;
      weights[Mesh::next_in_face(h) % 3] = t;
      sources.push_back({SurfacePoint::in_face(Mesh::face_of(h), weights), 0.0});
    }
  }
  sort_once(vertices);
  for (Index v : vertices) sources.push_back({SurfacePoint::at_vertex(v), 0.0});
  return sources;
}

}  // namespace vorogeo
