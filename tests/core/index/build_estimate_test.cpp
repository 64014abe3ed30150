// Estimates of a build, against the index that is then built.
#include "index/build_estimate.h"

#include <gtest/gtest.h>

#include "index/memory_budget.h"
#include "patches/partition.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(BuildEstimate, SaysWhatTheIndexWillHold) {
  for (const test::Soup& soup :
       {test::icosphere(4), test::drilled_plate(5, 4, 0.2, 3), test::hills(50, 0.3)}) {
    const auto index = test::make_index(soup);
    const BuildEstimate estimate = estimate_build(test::make_mesh(soup));
    EXPECT_GT(estimate.bytes, 0.5 * index->statistics().bytes);
    EXPECT_LT(estimate.bytes, 2.0 * index->statistics().bytes);
    EXPECT_EQ(estimate.form, IndexForm::tables);
    EXPECT_GT(estimate.build_seconds, 0.0);
    EXPECT_GE(estimate.core_seconds, estimate.build_seconds);
    EXPECT_GT(estimate.exact_field_seconds, 0.0);
    EXPECT_GT(estimate.field_seconds, 0.0);
  }
}

TEST(BuildEstimate, TakesPartsOfALargeMeshForTheWhole) {
  // Fewer faces than make a large mesh, and more, of the same surface.
  const BuildEstimate whole = estimate_build(test::make_mesh(test::torus(240, 120, 3.0, 1.0)), {}, false);
  const BuildEstimate parts = estimate_build(test::make_mesh(test::torus(480, 240, 3.0, 1.0)), {}, false);
  EXPECT_GT(parts.bytes, 2.5 * whole.bytes);
  EXPECT_LT(parts.bytes, 9.0 * whole.bytes);
  EXPECT_EQ(parts.exact_field_seconds, 0.0);
}

TEST(BuildEstimate, KeepsToThePatchesAskedFor) {
  IndexOptions options;
  options.first_layer_patches = 30;
  options.second_layer_patches = 6;
  const test::Soup soup = test::icosphere(4);
  const double held = test::make_index(soup, 30, 6)->statistics().bytes;
  const double estimated = estimate_build(test::make_mesh(soup), options, false).bytes;
  EXPECT_NEAR(estimated, held, 0.3 * held);
  const double of_usual_patches = estimate_build(test::make_mesh(soup), {}, false).bytes;
  EXPECT_GT(estimated, 1.5 * of_usual_patches);
}

/// With so many patches (0: chosen), the estimate has about the bytes of an index of tables, which all follow
/// from the layout.
void expect_bytes_laid_out(const std::shared_ptr<const Mesh>& mesh, Index first, Index second) {
  IndexData data;
  data.mesh = mesh;
  data.partition = make_partition(*data.mesh, {first, second}, {});
  data.lay_out(2, {});
  const double held = static_cast<double>(data.bytes() + table_bytes(data.second) + table_bytes(data.first) +
                                          transit_bytes(data.first, false) + access_bounds_bytes(data));
  IndexOptions options;
  options.first_layer_patches = first;
  options.second_layer_patches = second;
  EXPECT_NEAR(estimate_build(mesh, options, false).bytes, held, 0.3 * held);
}

TEST(BuildEstimate, PartsOfALargeMeshHaveTheirShareOfThePatchesAskedFor) {
  expect_bytes_laid_out(test::make_mesh(test::torus(300, 150, 3.0, 1.0)), 60, 5);
}

TEST(BuildEstimate, LargeMeshesWhoseComponentsAreFirstLayerPatchesHaveNoBordersThere) {
  test::Soup many = test::torus(60, 30, 3.0, 1.0);
  while (many.faces.size() < 80000) many = test::two_components(many, many);
  expect_bytes_laid_out(test::make_mesh(many), 0, 0);
}

TEST(BuildEstimate, ALargeMeshOfOneFirstLayerPatchHasNoBordersThere) {
  expect_bytes_laid_out(test::make_mesh(test::torus(240, 150, 3.0, 1.0)), 1, 100);
}

TEST(BuildEstimate, ChoosesTheFormByTheMemoryBudget) {
  IndexOptions options;
  options.memory_budget = 1;
  EXPECT_EQ(estimate_build(test::make_mesh(test::icosphere(5)), options, false).form, IndexForm::graph);
}

TEST(BuildEstimate, RefusesAMeshWithoutFacesAndIsCancelled) {
  EXPECT_THROW(estimate_build(test::make_mesh({{{0.0, 0.0, 0.0}}, {}})), InvalidInput);
  const Progress stop([](double, const std::string&) { return false; });
  EXPECT_THROW(estimate_build(test::make_mesh(test::icosphere(3)), {}, true, stop), Cancelled);
}

}  // namespace
}  // namespace vorogeo
