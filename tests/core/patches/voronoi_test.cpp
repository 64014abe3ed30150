// Voronoi labels of faces: nearest samples by formula, short borders, only the faces asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <queue>
#include <set>

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

TEST(Voronoi, FacesInsideACellHaveItsLabel) {
  const test::Shape plane = test::plane_grid(30, 24, 1.25, 1.0, 0.2);
  const auto mesh = test::make_mesh(plane.soup);
  const std::vector<Index> samples{60, 200, 333, 501, 640, 720};
  const auto label = voronoi_labels(mesh, samples);
  for (Index f = 0; f < mesh->face_count(); ++f) {
    ASSERT_GE(label[f], 0);
    ASSERT_LT(label[f], static_cast<Index>(samples.size()));
    // A face whose corners and the corners of its neighbours are all nearest to one sample is not near a
    // border.
    std::set<Index> nearest;
    for (Index v : mesh->face_vertices(f)) {
      for (Index corner : mesh->corners(v)) {
        for (Index u : mesh->face_vertices(Mesh::face_of(corner))) {
          Index best = 0;
          for (Index i = 1; i < static_cast<Index>(samples.size()); ++i) {
            if (plane.vertex_distance(u, samples[i]) < plane.vertex_distance(u, samples[best])) best = i;
          }
          nearest.insert(best);
        }
      }
    }
    if (nearest.size() != 1) continue;
    EXPECT_EQ(label[f], *nearest.begin()) << "face " << f;
  }
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

TEST(Voronoi, OtherFacesKeepTheirLabels) {
  const auto mesh = test::make_mesh(test::plane_grid(16, 16, 1.0, 1.0).soup);
  std::vector<std::uint8_t> allowed(mesh->face_count(), 0);
  std::vector<Index> faces;
  for (Index f = 0; f < mesh->face_count() / 2; ++f) {
    allowed[f] = 1;
    faces.push_back(f);
  }
  std::vector<Index> vertices(9 * 17);
  std::iota(vertices.begin(), vertices.end(), 0);
  Front front(*mesh);
  std::vector<Index> label(mesh->face_count(), 77);
  label_voronoi_faces(front, *mesh, {vertices, allowed}, faces, std::vector<Index>{2, 100, 140}, {}, label);
  for (Index f = 0; f < mesh->face_count(); ++f) {
    if (allowed[f]) {
      EXPECT_LT(label[f], 3);
    } else {
      EXPECT_EQ(label[f], 77);
    }
  }
}

TEST(Voronoi, OneSampleTakesAll) {
  const auto mesh = test::make_mesh(test::icosphere(1));
  for (Index label : voronoi_labels(mesh, {7})) EXPECT_EQ(label, 0);
}

}  // namespace
}  // namespace vorogeo
