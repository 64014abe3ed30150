// A program of the VCG library: a field from selected vertices into quality, a path into an edge mesh.
#include <vcg/complex/algorithms/create/platonic.h>
#include <vcg/complex/complex.h>
#include <vorogeo/vcg.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

class Vertex;
class Edge;
class Face;
struct Types
    : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Edge>::AsEdgeType, vcg::Use<Face>::AsFaceType> {
};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3d, vcg::vertex::Qualityd, vcg::vertex::BitFlags> {
};
class Edge : public vcg::Edge<Types, vcg::edge::VertexRef, vcg::edge::BitFlags> {};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::BitFlags> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Edge>, std::vector<Face>> {};

int main() {
  Mesh cube, line;
  vcg::tri::Hexahedron(cube);  // with sides of length 2
  cube.vert.front().SetS();

  const vorogeo::Surface surface = vorogeo::from_vcg(cube);
  vorogeo::write_quality(cube, surface.distances_from(vorogeo::selected_vertices(cube)));
  const auto farthest = std::max_element(cube.vert.begin(), cube.vert.end(),
                                         [](const Vertex& a, const Vertex& b) { return a.cQ() < b.cQ(); });
  vorogeo::add_path(line, surface.path(0, static_cast<int>(farthest - cube.vert.begin()), {.exact = true}));

  // The opposite corner is across two faces: the diagonal of a rectangle of 2 x 4.
  std::printf("the opposite corner is %.9f away, over %d edges\n", farthest->Q(), line.EN());
  return std::abs(farthest->Q() - std::sqrt(20.0)) < 1e-9 && line.EN() > 0 ? 0 : 1;
}
