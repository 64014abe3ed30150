// VoroGeo on meshes of the VCG library: surfaces and sources from them, answers into them. Header only.
//
//     #include <vorogeo/vcg.h>
//     vorogeo::Surface surface = vorogeo::from_vcg(mesh);
//     vorogeo::write_quality(mesh, surface.distances_from(vorogeo::selected_vertices(mesh)));
//
// Any mesh type will do whose vertices have coordinates and flags and whose faces have references to vertices
// and flags; float or double. Vertices and faces have the numbers of mesh.vert and mesh.face, deleted ones
// included: these belong to no surface and get no answer.
#pragma once

#include <vcg/complex/complex.h>
#include <vorogeo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vorogeo {
inline namespace v0 {

/// The quality of a vertex without a distance.
inline constexpr double quality_without_distance = -1.0;

namespace vcg_detail {

inline Point point_of(const auto& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// The number of a vertex that a face or an edge names. \throw InvalidInput for one that is not there.
template <class VcgMesh, class Vertex>
int number_of(const VcgMesh& mesh, const Vertex* vertex, const char* element, std::size_t number) {
  const auto* first = mesh.vert.data();
  const bool inside =
      vertex && !std::less<>()(vertex, first) && std::less<>()(vertex, first + mesh.vert.size());
  if (inside && !vertex->IsD()) return static_cast<int>(vertex - first);
  throw InvalidInput(element + std::to_string(number) + " names " +
                     (inside ? "vertex " + std::to_string(vertex - first) + ", which is deleted"
                             : "a vertex that is not in the mesh") +
                     "; remove it.");
}

inline void require(bool holds, const std::string& sentence) {
  if (!holds) throw InvalidInput(sentence);
}

inline void require_values(std::size_t values, std::size_t elements, const char* of) {
  require(values == elements, "There are " + std::to_string(values) + " values for " +
                                  std::to_string(elements) + " " + of +
                                  "; give one for each, also for deleted ones.");
}

}  // namespace vcg_detail

// ---- Surfaces and sources from VCG meshes

/// The surface of a VCG mesh, which is copied and may change or be destroyed afterwards. \throw InvalidInput
/// also for a face that names no vertex, a deleted one or one of another mesh.
template <class VcgMesh>
Surface from_vcg(const VcgMesh& mesh, SurfaceOptions options = {}) {
  std::vector<Point> positions;
  positions.reserve(mesh.vert.size());
  for (const auto& vertex : mesh.vert) {
    positions.push_back(vertex.IsD() ? Point{} : vcg_detail::point_of(vertex.cP()));
  }
  std::vector<std::array<int, 3>> faces(mesh.face.size());  // a face that names one vertex thrice is left out
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (mesh.face[f].IsD()) continue;
    for (int i = 0; i < 3; ++i) faces[f][i] = vcg_detail::number_of(mesh, mesh.face[f].cV(i), "Face ", f);
  }
  return {std::move(positions), std::move(faces), options};
}

/// The quality of the vertices, as SurfaceOptions::vertex_cost takes it.
template <class VcgMesh>
std::vector<double> vertex_cost_from_vcg(const VcgMesh& mesh) {
  vcg_detail::require(
      vcg::tri::HasPerVertexQuality(mesh),
      "The vertices of the VCG mesh have no quality that could be a cost; add it to their type.");
  std::vector<double> cost;
  cost.reserve(mesh.vert.size());
  for (const auto& vertex : mesh.vert) cost.push_back(vertex.IsD() ? 1.0 : static_cast<double>(vertex.cQ()));
  return cost;
}

/// The selected vertices: sources, sites, points of a matrix.
template <class VcgMesh>
PointList selected_vertices(const VcgMesh& mesh) {
  std::vector<int> vertices;
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    if (!mesh.vert[v].IsD() && mesh.vert[v].IsS()) vertices.push_back(static_cast<int>(v));
  }
  return vertices;
}

/// The selected faces as SurfaceOptions::mask, which leaves the others out.
template <class VcgMesh>
std::vector<bool> selected_faces(const VcgMesh& mesh) {
  std::vector<bool> selected;
  selected.reserve(mesh.face.size());
  for (const auto& face : mesh.face) selected.push_back(!face.IsD() && face.IsS());
  return selected;
}

/// The points of the surface nearest to those of an edge mesh: to its vertices, and to points along its
/// edges, at most `spacing` apart. As sources they stand for the curves. \throw InvalidInput for a spacing
/// that is not above 0, or one that would give an edge more than ten million points.
template <class VcgMesh>
PointList points_along(const Surface& surface, const VcgMesh& curves, double spacing) {
  vcg_detail::require(
      spacing > 0.0 && std::isfinite(spacing),
      "The spacing of points along curves is " + std::to_string(spacing) + "; give a length above 0.");
  std::vector<SurfacePoint> points;
  for (const auto& vertex : curves.vert) {
    if (!vertex.IsD()) points.push_back(surface.snap(vcg_detail::point_of(vertex.cP())));
  }
  for (std::size_t e = 0; e < curves.edge.size(); ++e) {
    const auto& edge = curves.edge[e];
    if (edge.IsD()) continue;
    for (int i = 0; i < 2; ++i) vcg_detail::number_of(curves, edge.cV(i), "Edge ", e);
    const Point a = vcg_detail::point_of(edge.cV(0)->cP()), b = vcg_detail::point_of(edge.cV(1)->cP());
    const double parts = std::ceil(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) / spacing);
    vcg_detail::require(parts <= 1e7, "Edge " + std::to_string(e) + " would get " + std::to_string(parts) +
                                          " points; give a larger spacing.");
    for (double i = 1.0; i < parts; i += 1.0) {
      const double t = i / parts;
      points.push_back(
          surface.snap({std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), std::lerp(a[2], b[2], t)}));
    }
  }
  return points;
}

// ---- Answers into VCG meshes

/// Writes a value for each vertex into its quality; `quality_without_distance` where it is not finite.
template <class VcgMesh>
void write_quality(VcgMesh& mesh, const std::vector<double>& values) {
  vcg_detail::require(vcg::tri::HasPerVertexQuality(mesh),
                      "The vertices of the VCG mesh have no quality to write to; add it to their type.");
  vcg_detail::require_values(values.size(), mesh.vert.size(), "vertices");
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (mesh.vert[v].IsD()) continue;
    using Quality = std::remove_cvref_t<decltype(mesh.vert[v].Q())>;
    mesh.vert[v].Q() = static_cast<Quality>(std::isfinite(values[v]) ? values[v] : quality_without_distance);
  }
}

/// Colours the faces by region, for example by VoronoiRegions::face_region; grey for -1.
template <class VcgMesh>
void color_faces(VcgMesh& mesh, const std::vector<int>& region) {
  vcg_detail::require(vcg::tri::HasPerFaceColor(mesh),
                      "The faces of the VCG mesh have no colour to write to; add it to their type.");
  vcg_detail::require_values(region.size(), mesh.face.size(), "faces");
  const int count = region.empty() ? 0 : *std::max_element(region.begin(), region.end()) + 1;
  for (std::size_t f = 0; f < region.size(); ++f) {
    if (mesh.face[f].IsD()) continue;
    mesh.face[f].C() = region[f] < 0 ? vcg::Color4b(160, 160, 160, 255)
                                     : vcg::Color4b::Scatter(count, region[f], 0.5F, 0.95F);
  }
}

/// Adds lines to an edge mesh: borders of regions, isolines.
template <class VcgMesh>
void add_lines(VcgMesh& curves, const SurfaceLines& lines) {
  using Coordinates = typename VcgMesh::CoordType;
  using Scalar = typename VcgMesh::ScalarType;
  const std::size_t first = curves.vert.size();
  auto vertex = vcg::tri::Allocator<VcgMesh>::AddVertices(curves, lines.points.size());
  for (const Point& p : lines.points) {
    (vertex++)->P() =
        Coordinates(static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]), static_cast<Scalar>(p[2]));
  }
  auto edge = vcg::tri::Allocator<VcgMesh>::AddEdges(curves, lines.segments.size());
  for (const auto& [a, b] : lines.segments) {
    edge->V(0) = &curves.vert[first + static_cast<std::size_t>(a)];
    (edge++)->V(1) = &curves.vert[first + static_cast<std::size_t>(b)];
  }
}

/// Adds a path to an edge mesh, as one polyline.
template <class VcgMesh>
void add_path(VcgMesh& curves, const Path& path) {
  SurfaceLines lines{path.points, {}};
  for (int i = 1; i < static_cast<int>(path.points.size()); ++i) lines.segments.push_back({i - 1, i});
  add_lines(curves, lines);
}

}  // namespace v0
}  // namespace vorogeo
