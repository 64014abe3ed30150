// Minimum cuts, and borders between patches after them.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "patches/border_cut.h"
#include "support/indexes.h"
#include "support/parallel.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Minimum cuts: against all cuts of small graphs.

struct Edge {
  Index a;
  Index b;
  std::int64_t capacity;
};

template <class BesideSource>
std::int64_t capacity_of_cut(const std::vector<Edge>& edges, BesideSource&& beside_source) {
  std::int64_t sum = 0;
  for (const Edge& edge : edges) {
    if (beside_source(edge.a) != beside_source(edge.b)) sum += edge.capacity;
  }
  return sum;
}

TEST(MinCut, NoOtherCutOfARandomGraphIsCheaper) {
  MinCut cut;
  const auto seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int graph = 0; graph < 50; ++graph) {
    constexpr unsigned nodes = 8;
    std::vector<Edge> edges;
    for (int i = 0; i < 16; ++i) {
      const auto a = static_cast<Index>(random() % nodes);
      const auto b = static_cast<Index>(random() % nodes);
      if (a != b) edges.push_back({a, b, static_cast<std::int64_t>(random() % 10)});
    }
    cut.reset(nodes);
    for (const Edge& edge : edges) cut.join(edge.a, edge.b, edge.capacity);
    const std::int64_t found = cut.run();
    EXPECT_TRUE(cut.beside_source(MinCut::source));
    EXPECT_FALSE(cut.beside_source(MinCut::sink));
    EXPECT_EQ(found, capacity_of_cut(edges, [&](Index node) { return cut.beside_source(node); }));
    for (unsigned set = 0; set < 1U << nodes; ++set) {
      if ((set & 1U) == 0 || (set & 2U) != 0) continue;
      const auto other = capacity_of_cut(edges, [&](Index node) { return (set >> node & 1U) != 0; });
      ASSERT_LE(found, other);
    }
  }
}

// Borders after minimum cuts: as short as possible, and found at once.

/// Edges between faces with different labels, and their length.
struct Border {
  int edges = 0;
  double length = 0.0;
};
Border border_of(const Mesh& mesh, const std::vector<Index>& label) {
  Border border;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.edge_halfedge(e);
    const Index other = mesh.next_around_edge(h);
    if (label[Mesh::face_of(h)] == label[Mesh::face_of(other)]) continue;
    ++border.edges;
    border.length += mesh.edge_length(e);
  }
  return border;
}

/// A label for each face of a grid, by the column and row of its cell.
template <class LabelOf>
std::vector<Index> grid_labels(const Mesh& mesh, Index columns, LabelOf&& label_of) {
  std::vector<Index> label(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) label[f] = label_of(f / 2 % columns, f / 2 / columns);
  return label;
}

TEST(BorderCut, ARaggedBorderOfAGridBecomesStraight) {
  const auto mesh = test::make_mesh(test::plane_grid(20, 20, 20.0, 20.0).soup);
  // Teeth of two by two cells: 20 edges along the border, and two across at each of 9 steps.
  auto label = grid_labels(*mesh, 20, [](Index i, Index j) { return i < 10 + (j / 2 % 2 == 0 ? 1 : -1); });
  EXPECT_EQ(border_of(*mesh, label).edges, 20 + 2 * 9);
  BorderCut(*mesh).shorten(test::all_faces(*mesh), 2, 400.0, {}, label);
  EXPECT_EQ(border_of(*mesh, label).edges, 20);
  EXPECT_DOUBLE_EQ(border_of(*mesh, label).length, 20.0);
}

TEST(BorderCut, PagesOfABookMakeARing) {
  // Three patches one after the other, and a page of the first in the middle of the second.
  constexpr Index pages = 20'000;
  const auto mesh = test::make_mesh(test::book_of_pages(pages));
  std::vector<Index> label(pages);
  for (Index f = 0; f < pages; ++f) label[f] = f < 5000 || f == 8000 ? 0 : f < 12'000 ? 2 : 1;
  const double start = thread_seconds();
  BorderCut(*mesh).shorten(test::all_faces(*mesh), 3, 6000.0, {}, label);
  // Quadratic work would take seconds.
  EXPECT_LT(thread_seconds() - start, 0.5);
  EXPECT_EQ(label[8000], 2);
  for (Index patch : {0, 1, 2}) EXPECT_GT(std::ranges::count(label, patch), 1000) << patch;
}

}  // namespace
}  // namespace vorogeo
