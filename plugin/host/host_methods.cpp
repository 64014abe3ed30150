// Copies the component of the source into a small VCG mesh and runs VCG's algorithms on it.
#include "host/host_methods.h"

#include <vcg/complex/algorithms/geodesic.h>
#include <vcg/complex/complex.h>

#include "host/filter_row.h"
#if VOROGEO_HOST_VERSION >= 202301
#include <vcg/complex/algorithms/geodesic_heat.h>
#endif

#include <cmath>
#include <limits>

#include "query/rent_or_buy.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

template <class T>
class FaceQuality : public vcg::face::Quality<Scalarm, T> {};
class MethodVertex;
class MethodFace;
struct MethodTypes : vcg::UsedTypes<vcg::Use<MethodVertex>::AsVertexType, vcg::Use<MethodFace>::AsFaceType> {
};
class MethodVertex
    : public vcg::Vertex<MethodTypes, vcg::vertex::Coord3m, vcg::vertex::Normal3m, vcg::vertex::Qualitym,
                         vcg::vertex::VFAdj, vcg::vertex::Mark, vcg::vertex::BitFlags> {};
class MethodFace : public vcg::Face<MethodTypes, vcg::face::VertexRef, vcg::face::Normal3m, FaceQuality,
                                    vcg::face::VFAdj, vcg::face::FFAdj, vcg::face::BitFlags> {};
class MethodMesh : public vcg::tri::TriMesh<std::vector<MethodVertex>, std::vector<MethodFace>> {};

/// The faces connected to the source, as a VCG mesh, and the numbers of its vertices.
struct Component {
  MethodMesh mesh;
  std::vector<Index> vertex_of;  ///< in the mesh from which it was taken
  std::vector<MethodVertex*> source;
};

void take_component(const Mesh& mesh, Index source, Component& taken) {
  std::vector<Index> number(static_cast<std::size_t>(mesh.vertex_count()), no_index);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.component(v) != mesh.component(source) || mesh.representative(v) != v) continue;
    number[v] = static_cast<Index>(taken.vertex_of.size());
    taken.vertex_of.push_back(v);
  }
  std::vector<const std::array<Index, 3>*> faces;
  for (const auto& face : mesh.faces()) {
    if (number[face[0]] != no_index) faces.push_back(&face);
  }
  vcg::tri::Allocator<MethodMesh>::AddVertices(taken.mesh, taken.vertex_of.size());
  for (std::size_t i = 0; i < taken.vertex_of.size(); ++i) {
    const Point& p = mesh.position(taken.vertex_of[i]);
    taken.mesh.vert[i].P() = Point3m(Scalarm(p[0]), Scalarm(p[1]), Scalarm(p[2]));
    taken.mesh.vert[i].Q() = std::numeric_limits<Scalarm>::max();
  }
  vcg::tri::Allocator<MethodMesh>::AddFaces(taken.mesh, faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) taken.mesh.face[f].V(i) = &taken.mesh.vert[number[(*faces[f])[i]]];
  }
  taken.source = {&taken.mesh.vert[number[source]]};
}

void read_quality(const Component& taken, const Mesh& mesh, MethodField& field) {
  field.distances.assign(static_cast<std::size_t>(mesh.vertex_count()), unreachable);
  for (std::size_t i = 0; i < taken.vertex_of.size(); ++i) {
    const Scalarm quality = taken.mesh.vert[i].cQ();
    const bool reached = quality < std::numeric_limits<Scalarm>::max();
    field.distances[taken.vertex_of[i]] = reached || std::isnan(quality) ? double(quality) : unreachable;
  }
}

/// Runs and times a method: run(taken, prepare(mesh)).
template <class Prepare, class Run>
MethodField timed_field(const Mesh& mesh, Index source, Prepare prepare, Run run) {
  Component taken;
  take_component(mesh, source, taken);
  MethodField field;
  const Stopwatch preparing;
  auto prepared = prepare(taken.mesh);
  field.build_seconds = preparing.seconds();
  const Stopwatch running;
  run(taken, prepared);
  field.seconds = running.seconds();
  read_quality(taken, mesh, field);
  return field;
}

/// The faces around each vertex.
bool find_faces(MethodMesh& mesh) {
  vcg::tri::UpdateTopology<MethodMesh>::VertexFace(mesh);
  return true;
}

}  // namespace

MethodField fast_marching_field(const Mesh& mesh, Index source) {
  return timed_field(mesh, source, find_faces, [](Component& taken, bool) {
    vcg::tri::Geodesic<MethodMesh>::Compute(taken.mesh, taken.source);
  });
}

MethodField edge_graph_field(const Mesh& mesh, Index source) {
  return timed_field(mesh, source, find_faces, [](Component& taken, bool) {
    vcg::tri::EuclideanDistance<MethodMesh> edge_length;
    vcg::tri::Geodesic<MethodMesh>::PerVertexDijkstraCompute(taken.mesh, taken.source, edge_length);
  });
}

#if VOROGEO_HOST_VERSION >= 202301

MethodField heat_field(const Mesh& mesh, Index source) {
  using Heat = vcg::tri::GeodesicHeat<MethodMesh>;
  const auto prepare = [](MethodMesh& taken) { return Heat::BuildCache(taken); };
  return timed_field(mesh, source, prepare, [](Component& taken, auto& factorisation) {
    const bool factorised =
        factorisation.first->info() == Eigen::Success && factorisation.second->info() == Eigen::Success;
    if (!factorised || !Heat::ComputeFromCache(taken.mesh, taken.source, factorisation)) {
      throw InvalidInput(
          "The heat method fails on this mesh: its matrices cannot be factorised, mostly because of "
          "zero-area faces. Repair the mesh or choose another method.");
    }
  });
}

#else

MethodField heat_field(const Mesh&, Index) {
  throw InvalidInput("MeshLab 2022.02 has no heat method; later versions have. Choose another method.");
}

#endif

}  // namespace vorogeo::plugin
