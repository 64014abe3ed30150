// Two layers of patches: counts, nesting, determinism, defects, refusals.
#include "patches/partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/error.h"
#include "support/indexes.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

Partition partition_of(const Soup& soup, const PartitionOptions& options = {},
                       const Progress& progress = {}) {
  return make_partition(*test::make_mesh(soup), options, progress);
}

void expect_valid(const Partition& partition, Index faces) {
  ASSERT_EQ(static_cast<Index>(partition.first_layer.size()), faces);
  ASSERT_EQ(static_cast<Index>(partition.second_layer.size()), faces);
  ASSERT_EQ(static_cast<Index>(partition.parent.size()), partition.second_layer_count);
  EXPECT_TRUE(std::is_sorted(partition.parent.begin(), partition.parent.end()));
  std::vector<int> first(partition.first_layer_count, 0);
  std::vector<int> second(partition.second_layer_count, 0);
  for (Index f = 0; f < faces; ++f) {
    const Index p = partition.first_layer[f];
    const Index q = partition.second_layer[f];
    ASSERT_TRUE(p >= 0 && p < partition.first_layer_count) << "face " << f;
    ASSERT_TRUE(q >= 0 && q < partition.second_layer_count) << "face " << f;
    EXPECT_EQ(partition.parent[q], p) << "face " << f;
    ++first[p];
    ++second[q];
  }
  EXPECT_TRUE(std::find(first.begin(), first.end(), 0) == first.end()) << "an empty patch";
  EXPECT_TRUE(std::find(second.begin(), second.end(), 0) == second.end()) << "an empty patch";
}

TEST(Partition, EveryFaceInOnePatchOfEachLayer) {
  const Soup two = test::two_components(test::icosphere(3), test::torus(30, 14, 2.0, 0.7));
  for (const Soup& soup :
       {test::icosphere(4), test::hills(30, 0.2), test::book_of_three_pages(12, 2.0, 1.0).soup,
        test::bow_tie(10).soup, test::with_isolated_vertex(two, {5, 5, 5}),
        test::with_zero_area_cap(test::icosphere(2), 11, 0)}) {
    const Index faces = test::make_mesh(soup)->face_count();
    for (Index n1 : {0, 1, 3}) {
      for (Index n2 : {0, 1, 5}) {
        PartitionOptions options;
        options.first_layer_patches = n1;
        options.second_layer_patches = n2;
        expect_valid(partition_of(soup, options), faces);
      }
    }
  }
}

TEST(Partition, TheNumbersAskedForAreMade) {
  const Soup soup = test::icosphere(4);
  for (Index n1 : {1, 2, 5, 9}) {
    for (Index n2 : {1, 3, 8}) {
      PartitionOptions options;
      options.first_layer_patches = n1;
      options.second_layer_patches = n2;
      const Partition partition = partition_of(soup, options);
      EXPECT_EQ(partition.first_layer_count, n1);
      EXPECT_EQ(partition.second_layer_count, n1 * n2);
    }
  }
}

TEST(Partition, AutomaticNumbersGrowWithTheMesh) {
  const Partition small = partition_of(test::icosphere(2));
  EXPECT_EQ(small.first_layer_count, 1);
  EXPECT_EQ(small.second_layer_count, 1);
  const Partition medium = partition_of(test::icosphere(5));  // 10,242 vertices
  EXPECT_GE(medium.second_layer_count, 2 * medium.first_layer_count);
  EXPECT_LT(medium.second_layer_count, 200);
  const Partition large = partition_of(test::hills(200, 0.1));  // 40,401 vertices
  EXPECT_GT(large.first_layer_count, 1);
  EXPECT_GT(large.first_layer_count, medium.first_layer_count);
  EXPECT_GT(large.second_layer_count, 2 * medium.second_layer_count);
}

TEST(Partition, AutomaticPatchesHaveSimilarSizes) {
  for (const Soup& soup : {test::icosphere(5), test::hills(90, 0.1)}) {
    const Partition partition = partition_of(soup);
    std::vector<Index> faces(partition.second_layer_count, 0);
    for (Index p : partition.second_layer) ++faces[p];
    const double mean = static_cast<double>(partition.second_layer.size()) / partition.second_layer_count;
    EXPECT_LT(*std::max_element(faces.begin(), faces.end()), 2.5 * mean);
    EXPECT_GT(*std::min_element(faces.begin(), faces.end()), mean / 5.0);
  }
}

TEST(Partition, TheSameForASeedWhateverTheThreads) {
  const Soup soup = test::hills(50, 0.2);
  PartitionOptions options;
  options.first_layer_patches = 6;
  options.second_layer_patches = 5;
  options.seed = 9;
  options.threads = 1;
  const Partition one = partition_of(soup, options);
  for (int threads : {1, 2, 5}) {
    options.threads = threads;
    const Partition other = partition_of(soup, options);
    EXPECT_EQ(other.first_layer, one.first_layer) << threads << " threads";
    EXPECT_EQ(other.second_layer, one.second_layer) << threads << " threads";
    EXPECT_EQ(other.parent, one.parent) << threads << " threads";
  }
  options.seed = 10;
  EXPECT_NE(partition_of(soup, options).second_layer, one.second_layer);
}

TEST(Partition, EachComponentHasPatchesOfItsOwn) {
  Soup soup = test::icosphere(2);
  for (int i = 0; i < 4; ++i) soup = test::two_components(soup, test::icosphere(i % 3));
  const auto mesh = test::make_mesh(soup);
  const Partition partition = partition_of(soup);
  std::vector<std::set<Index>> components(partition.second_layer_count);
  for (Index f = 0; f < mesh->face_count(); ++f) {
    components[partition.second_layer[f]].insert(mesh->component(mesh->face_vertices(f)[0]));
  }
  for (const auto& own : components) EXPECT_EQ(own.size(), 1U);
}

TEST(Partition, RealMeshesWithDefects) {
  for (const char* name : {"office_chair", "greek_helmet", "cow"}) {
    VOROGEO_READ_OR_SKIP(soup, name);
    expect_valid(partition_of(soup), test::make_mesh(soup)->face_count());
  }
}

TEST(Partition, TinyMeshes) {
  const Soup triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  expect_valid(partition_of(triangle), 1);
  const Soup square{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}};
  for (Index n : {0, 1, 2}) {
    PartitionOptions options;
    options.first_layer_patches = n;
    options.second_layer_patches = n;
    expect_valid(partition_of(square, options), 2);
  }
}

TEST(Partition, Refusals) {
  auto refusal = [](const Soup& soup, Index n1, Index n2) -> std::string {
    PartitionOptions options;
    options.first_layer_patches = n1;
    options.second_layer_patches = n2;
    try {
      partition_of(soup, options);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_EQ(refusal({{{0, 0, 0}}, {}}, 0, 0), "The mesh has no face; geodesic distances need a surface.");
  const std::string range = "; give one from 0 (automatic) to 20, the number of faces.";
  EXPECT_EQ(refusal(test::icosphere(0), -1, 0), "The number of first-layer patches, n1, is -1" + range);
  EXPECT_EQ(refusal(test::icosphere(0), 21, 0), "The number of first-layer patches, n1, is 21" + range);
  EXPECT_EQ(refusal(test::icosphere(0), 0, 21), "The number of second-layer patches, n2, is 21" + range);
  EXPECT_EQ(refusal(test::icosphere(0), 20, 20), "not refused");
}

TEST(Partition, CancelledAtAnyReport) {
  const Soup soup = test::icosphere(3);
  int reports = 0;
  partition_of(soup, {}, Progress([&](double, const std::string&) { return ++reports > 0; }));
  EXPECT_GE(reports, 3);
  for (int allowed = 0; allowed < reports; ++allowed) {
    int seen = 0;
    EXPECT_THROW(
        partition_of(soup, {}, Progress([&](double, const std::string&) { return seen++ < allowed; })),
        Cancelled);
  }
}

}  // namespace
}  // namespace vorogeo
