// Building an index in the background: its result, cancelling, and errors as sentences.
#include "edit/index_preparation.h"

#include <gtest/gtest.h>

#include <future>
#include <utility>

#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo::plugin {
namespace {

/// Starts a build; the future has its result.
std::future<IndexPreparation::Result> start(IndexPreparation& preparation, IndexPreparation::Build build) {
  auto promise = std::make_shared<std::promise<IndexPreparation::Result>>();
  auto future = promise->get_future();
  preparation.start(std::move(build),
                    [promise](IndexPreparation::Result result) { promise->set_value(std::move(result)); });
  return future;
}

IndexPreparation::Build build_of(std::shared_ptr<const Mesh> mesh) {
  return [mesh](const Progress& progress) { return GeodesicIndex::build(mesh, {}, progress); };
}

TEST(IndexPreparation, BuildsAnIndexOfTheMesh) {
  const auto mesh = test::make_mesh(test::icosphere(2));
  IndexPreparation preparation;
  const auto result = start(preparation, build_of(mesh)).get();
  ASSERT_NE(result.index, nullptr);
  EXPECT_EQ(result.index->mesh(), mesh);
  EXPECT_EQ(result.error, "");
  EXPECT_FALSE(preparation.is_running());
}

TEST(IndexPreparation, CancelledInTheMiddleItGivesNeitherIndexNorError) {
  const auto mesh = test::make_mesh(test::icosphere(5));
  IndexPreparation preparation;
  auto result = start(preparation, build_of(mesh));
  while (preparation.is_running() && preparation.fraction() == 0.0) std::this_thread::yield();
  preparation.cancel();
  EXPECT_FALSE(preparation.is_running());
  const auto found = result.get();
  EXPECT_EQ(found.index, nullptr);
  EXPECT_EQ(found.error, "");
}

TEST(IndexPreparation, AnErrorIsASentence) {
  IndexPreparation preparation;
  const auto bad = [](const Progress&) -> std::shared_ptr<const GeodesicIndex> {
    throw InvalidInput("Face 7 is bad; remove it.");
  };
  const auto result = start(preparation, bad).get();
  EXPECT_EQ(result.index, nullptr);
  EXPECT_EQ(result.error, "Face 7 is bad; remove it.");
}

TEST(IndexPreparation, TheExpectedTimeGrowsWithTheMeshAndFallsWithThreads) {
  EXPECT_DOUBLE_EQ(expected_build_seconds(200000, 1), 2.0 * expected_build_seconds(100000, 1));
  EXPECT_DOUBLE_EQ(expected_build_seconds(100000, 4), 0.25 * expected_build_seconds(100000, 1));
  EXPECT_DOUBLE_EQ(expected_build_seconds(100000, 0), expected_build_seconds(100000, 1));
}

}  // namespace
}  // namespace vorogeo::plugin
