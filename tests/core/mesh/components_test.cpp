// Counts of components, on soups whose components are known.
#include <gtest/gtest.h>

#include "mesh/outliers.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(Components, OnlyThoseWithFacesAreSurfaces) {
  const test::Soup pair = test::two_components(test::icosphere(1), test::icosphere(2));
  const auto mesh = test::make_mesh(test::with_isolated_vertex(pair, {9.0, 9.0, 9.0}));
  EXPECT_EQ(mesh->component_count(), 3);
  EXPECT_EQ(components_with_faces(*mesh), 2);
  EXPECT_EQ(components_with_faces(*test::make_mesh({{{0.0, 0.0, 0.0}}, {}})), 0);
}

TEST(Components, TheLargestHasTheMostVertices) {
  // 42 and 162 vertices.
  const test::Soup pair = test::two_components(test::icosphere(1), test::icosphere(2));
  const LargestComponent largest = largest_component(*test::make_mesh(pair));
  EXPECT_EQ(largest.first_vertex, 42);
  EXPECT_EQ(largest.vertices, 162);
  const test::Soup alike = test::two_components(test::icosphere(1), test::icosphere(1));
  EXPECT_EQ(largest_component(*test::make_mesh(alike)).first_vertex, 0);
  EXPECT_EQ(largest_component(*test::make_mesh({})).first_vertex, no_index);
}

}  // namespace
}  // namespace vorogeo
