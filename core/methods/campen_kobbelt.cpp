// Waves over raw meshes that cross whatever is nearer in space than a tolerance.
#include <cmath>

#include "mesh/surface_locator.h"
#include "mesh/vectors.h"
#include "methods/fast_marching.h"
#include "methods/method.h"
#include "support/error.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// Triangles across gaps for each vertex, in the mean, beyond which a gap is refused: it is many edges wide,
/// and everything would be joined to everything around it.
constexpr std::size_t max_triangles_per_vertex = 500;

double distance_to_face(const Mesh& mesh, Index vertex, const std::array<Index, 3>& face) {
  const Point& p = mesh.position(vertex);
  const auto weights =
      nearest_weights(p, mesh.position(face[0]), mesh.position(face[1]), mesh.position(face[2]));
  Point away{};
  for (int i = 0; i < 3; ++i) away = moved(away, weights[i], minus(mesh.position(face[i]), p));
  return length_of(away);
}

/// The faces of the mesh without its bridges, and for each vertex and each face that is no farther from it
/// than the gap and does not have it as a corner, the triangles from the vertex to the sides of the face.
std::shared_ptr<const Mesh> joined_wherever_near(const Mesh& mesh, double gap) {
  if (mesh.has_metric() || !mesh.has_positions()) {
    throw InvalidInput(
        "The method campen_kobbelt crosses gaps by their width in space, so not in a metric; set its gap to "
        "0 or leave out the metric.");
  }
  std::vector<std::array<Index, 3>> faces(mesh.faces().begin(), mesh.faces().begin() + mesh.first_bridge());
  std::vector<Box> boxes;
  for (const auto& face : faces) {
    Box box{mesh.position(face[0]), mesh.position(face[0])};
    for (const Index v : face) box.add({mesh.position(v), mesh.position(v)});
    boxes.push_back(box);
  }
  const BoxTree tree(boxes);
  const std::size_t most = faces.size() + max_triangles_per_vertex * mesh.vertex_count();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (v % 1024 == 0) checkpoint();
    if (mesh.corners(v).empty()) continue;
    const auto join = [&](Index f) {
      const std::array<Index, 3> face = faces[f];
      if (std::ranges::find(face, v) != face.end() || distance_to_face(mesh, v, face) > gap) return gap;
      for (int i = 0; i < 3; ++i) faces.push_back({v, face[i], face[(i + 1) % 3]});
      return gap;
    };
    tree.visit_near({mesh.position(v), mesh.position(v)}, gap, mesh.face_count(), join,
                    [](Index) { return false; });
    if (faces.size() > most) {
      throw InvalidInput(
          "The gap of the method campen_kobbelt is " + std::to_string(gap / mesh.typical_edge_length()) +
          " typical edges wide, and joins each vertex to hundreds of faces; give a smaller one.");
    }
  }
  return std::make_shared<const Mesh>(mesh.positions(), faces);
}

}  // namespace

// After the abstract of the paper: distances on raw meshes without a repair, holes and gaps bridged up to a
// tolerance, whatever lies on their sides. The front is that of fast marching, not of the paper's cells.
MethodEntry campen_kobbelt_entry() {
  return {
      {"campen_kobbelt",
       "Waves across gaps (Campen, Kobbelt)",
       "M. Campen, L. Kobbelt: Walking on broken mesh: defect-tolerant geodesic distances and "
       "parameterizations. Computer Graphics Forum 30(2), 2011",
       {{"gap", 0.0, 0.0, 1e60, false, "width in space that waves cross anywhere, in the unit of the mesh"}},
       {"MSAD", "adjacency", "none; short cuts between what is near in space", "none", "field n log n"},
       false,
       false},
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress& progress) {
        const Watch watch(progress, "Gaps");
        const double gap = options.at("gap");
        return std::make_unique<FastMarching>(gap > 0.0 ? joined_wherever_near(*mesh, gap) : mesh);
      },
      {}};
}

}  // namespace vorogeo
