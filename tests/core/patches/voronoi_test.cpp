// Voronoi labels of faces: nearest samples by formula, short borders, only the faces asked for.
#include <gtest/gtest.h>

#include <numeric>
#include <queue>

#include "patches/sampling.h"
#include "support/indexes.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

std::vector<Index> all_faces(const Mesh& mesh) {
  std::vector<Index> faces(mesh.face_count());
  std::iota(faces.begin(), faces.end(), 0);
  return faces;
}

std::vector<Index> voronoi_labels(const std::shared_ptr<const Mesh>& mesh,
                                  const std::vector<Index>& samples) {
  Front front(*mesh);
  std::vector<Index> label(mesh->face_count(), no_index);
  label_voronoi_faces(front, *mesh, {}, all_faces(*mesh), samples, {}, label);
  return label;
}

/// Labels as others make them: vertices by Dijkstra over the edges, a face like two of its corners.
std::vector<Index> edge_graph_labels(const Mesh& mesh, const std::vector<Index>& samples) {
  std::vector<double> distance(mesh.vertex_count(), unreachable);
  std::vector<Index> nearest(mesh.vertex_count(), no_index);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    distance[samples[i]] = 0.0;
    nearest[samples[i]] = static_cast<Index>(i);
    queue.emplace(0.0, samples[i]);
  }
  while (!queue.empty()) {
    const auto [key, v] = queue.top();
    queue.pop();
    if (key > distance[v]) continue;
    for (Index corner : mesh.corners(v)) {
      for (Index h : {corner, Mesh::previous_in_face(corner)}) {
        const Index u = mesh.tail(h) == v ? mesh.head(h) : mesh.tail(h);
        const double through = key + mesh.edge_length(mesh.edge_of(h));
        if (through >= distance[u]) continue;
        distance[u] = through;
        nearest[u] = nearest[v];
        queue.emplace(through, u);
      }
    }
  }
  std::vector<Index> label(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [a, b, c] = mesh.face_vertices(f);
    label[f] = nearest[b] == nearest[c] ? nearest[b] : nearest[a];
  }
  return label;
}

double border_length(const Mesh& mesh, const std::vector<Index>& label) {
  double sum = 0.0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index first = mesh.edge_halfedge(e);
    bool border = false;
    for (Index h = mesh.next_around_edge(first); h != first; h = mesh.next_around_edge(h)) {
      border |= label[Mesh::face_of(h)] != label[Mesh::face_of(first)];
    }
    if (border) sum += mesh.edge_length(e);
  }
  return sum;
}

TEST(Voronoi, BordersAreNotLongerThanThoseOfPatchesGrownAlongEdges) {
  std::vector<std::pair<std::string, test::Soup>> meshes{{"icosphere", test::icosphere(4)},
                                                         {"random sphere", test::random_sphere(1500, 3)},
                                                         {"hills", test::hills(40, 0.15)}};
  for (const char* name : {"spot", "fandisk"}) {
    if (const auto file = test::test_mesh_file(name)) meshes.emplace_back(name, test::read_ply(*file));
  }
  for (const auto& [name, soup] : meshes) {
    const auto mesh = test::make_mesh(soup);
    std::vector<Index> vertices(mesh->vertex_count());
    std::iota(vertices.begin(), vertices.end(), 0);
    const auto samples = Sampler(*mesh).spread({vertices, {}}, 12, 4);
    const double short_border = border_length(*mesh, voronoi_labels(mesh, samples));
    const double along_edges = border_length(*mesh, edge_graph_labels(*mesh, samples));
    EXPECT_GT(short_border, 0.0);
    EXPECT_LE(short_border, 1.03 * along_edges) << name;
  }
}

TEST(Voronoi, NoFaceStandsAloneBetweenTwoNeighboursThatAgree) {
  const auto mesh = test::make_mesh(test::random_sphere(1200, 8));
  const auto label = voronoi_labels(mesh, {3, 300, 600, 900, 1100});
  for (Index f = 0; f < mesh->face_count(); ++f) {
    int agreeing = 0;
    for (int i = 0; i < 3; ++i) {
      agreeing += label[Mesh::face_of(mesh->next_around_edge(3 * f + i))] == label[f];
    }
    EXPECT_GE(agreeing, 1) << "face " << f;
  }
}

}  // namespace
}  // namespace vorogeo
