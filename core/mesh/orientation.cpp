// Which faces are turned against their neighbours.
#include "mesh/orientation.h"

namespace vorogeo {

std::vector<bool> turned_faces(const Mesh& mesh) {
  std::vector<bool> turned(mesh.face_count()), visited(mesh.face_count());
  for (Index first = 0; first < mesh.face_count(); ++first) {
    if (visited[first]) continue;
    visited[first] = true;
    std::vector<Index> part{first};
    std::size_t count = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Index f = part[i];
      count += turned[f] ? 1 : 0;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = other_side(mesh, h);
        if (g == no_index || visited[Mesh::face_of(g)]) continue;
        visited[Mesh::face_of(g)] = true;
        turned[Mesh::face_of(g)] = turned[f] != (mesh.tail(g) == mesh.tail(h));
        part.push_back(Mesh::face_of(g));
      }
    }
    if (2 * count <= part.size()) continue;
    for (const Index f : part) turned[f] = !turned[f];
  }
  return turned;
}

}  // namespace vorogeo
