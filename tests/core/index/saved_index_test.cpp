// Saved indexes: the same answers after loading; files of other meshes are refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "index/geodesic_index.h"
#include "index/index_data.h"
#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"
#include "support/temporary.h"

namespace vorogeo {
namespace {

using test::loading;
using test::read_bytes;
using test::Soup;
using test::TemporaryFolder;

void expect_equal_answers(const std::shared_ptr<const GeodesicIndex>& a,
                          const std::shared_ptr<const GeodesicIndex>& b) {
  GeodesicQuery query_a(a);
  GeodesicQuery query_b(b);
  const Index n = a->mesh()->vertex_count();
  for (Index source : test::random_vertices(n, 4, 2)) {
    EXPECT_EQ(query_a.distance_field(std::array{source}), query_b.distance_field(std::array{source}));
    for (Index target : test::random_vertices(n, 20, 3)) {
      EXPECT_EQ(query_a.distance(source, target), query_b.distance(source, target));
    }
  }
}

TEST(SavedIndex, AnswersAreTheSameToTheLastBit) {
  const TemporaryFolder folder;
  const Soup two = test::two_components(test::icosphere(2), test::hills(12, 0.2));
  for (const Soup& soup :
       {test::icosphere(3), test::with_isolated_vertex(two, {9, 9, 9}),
        test::book_of_three_pages(8, 2.0, 1.0).soup, test::with_zero_area_cap(test::icosphere(2), 7, 1),
        Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}) {
    for (double delta : {0.0, 0.01}) {
      const auto built = test::make_index(soup, std::min<Index>(3, static_cast<Index>(soup.faces.size())),
                                          std::min<Index>(4, static_cast<Index>(soup.faces.size())), delta);
      built->save(folder / "a.index");
      const auto loaded = GeodesicIndex::load(folder / "a.index", test::make_mesh(soup));
      expect_equal_answers(built, loaded);
      for (int layer : {1, 2}) {
        EXPECT_TRUE(std::ranges::equal(built->face_patches(layer), loaded->face_patches(layer)));
      }
      EXPECT_EQ(loaded->fingerprint(), built->fingerprint());
      const auto& a = built->statistics();
      const auto& b = loaded->statistics();
      EXPECT_EQ(b.vertices, a.vertices);
      EXPECT_EQ(b.faces, a.faces);
      EXPECT_EQ(b.components, a.components);
      EXPECT_EQ(b.first_layer_patches, a.first_layer_patches);
      EXPECT_EQ(b.second_layer_patches, a.second_layer_patches);
      EXPECT_EQ(b.first_layer_border_vertices, a.first_layer_border_vertices);
      EXPECT_EQ(b.second_layer_border_vertices, a.second_layer_border_vertices);
      EXPECT_EQ(b.arcs_before_pruning, a.arcs_before_pruning);
      EXPECT_EQ(b.arcs, a.arcs);
      EXPECT_EQ(b.bytes, a.bytes);
      EXPECT_EQ(b.delta, delta);
      EXPECT_EQ(b.seed, a.seed);
      EXPECT_EQ(b.seconds, 0.0);
      loaded->save(folder / "b.index");
      EXPECT_EQ(read_bytes(folder / "b.index"), read_bytes(folder / "a.index"));
    }
  }
}

/// Whether an address is in a part of the memory of this process that is mapped to a file.
bool in_file(const void* place, const std::filesystem::path& file) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0;
    std::uintptr_t end = 0;
    std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR, &begin, &end);
    const auto at = reinterpret_cast<std::uintptr_t>(place);
    if (begin <= at && at < end) return line.ends_with(file.string());
  }
  return false;
}

TEST(SavedIndex, LargeTablesLieInTheFileOrAreCopied) {
  if (!std::filesystem::exists("/proc/self/maps")) GTEST_SKIP() << "this system does not list mappings";
  const TemporaryFolder folder;
  const auto file = folder / "a.index";
  const Soup soup = test::icosphere(3);
  test::make_index(soup, 3, 4)->save(file);
  const auto mesh = test::make_mesh(soup);
  for (TableStorage storage : {TableStorage::mapped, TableStorage::copied}) {
    const auto index = GeodesicIndex::load(file, mesh, storage);
    const IndexData& data = index->data();
    std::int64_t mapped = 0;
    for (const auto* table : {&data.second.table, &data.first.table, &data.transit_table.entry}) {
      ASSERT_FALSE(table->empty());
      EXPECT_EQ(in_file(table->data(), file), storage == TableStorage::mapped);
      mapped += storage == TableStorage::mapped ? static_cast<std::int64_t>(2 * table->size()) : 0;
    }
    EXPECT_EQ(index->statistics().mapped_bytes, mapped);
    EXPECT_LT(mapped, index->statistics().bytes);
  }
}

TEST(SavedIndex, AnswersWhileItsFileIsReplacedAndAfterItIsGone) {
  const TemporaryFolder folder;
  const auto file = folder / "a.index";
  const Soup soup = test::icosphere(3);
  const auto built = test::make_index(soup, 3, 4);
  built->save(file);
  const auto loaded = GeodesicIndex::load(file, test::make_mesh(soup));
  loaded->save(file);
  expect_equal_answers(built, loaded);
  test::make_index(test::icosphere(1), 2, 2)->save(file);
  expect_equal_answers(built, loaded);
  std::filesystem::remove(file);
  expect_equal_answers(built, loaded);
  loaded->save(file);
  expect_equal_answers(built, GeodesicIndex::load(file, test::make_mesh(soup), TableStorage::copied));
}

TEST(SavedIndex, BelongsToItsMeshOnly) {
  const TemporaryFolder folder;
  const auto file = folder / "a.index";
  const Soup soup = test::icosphere(2);
  test::make_index(soup, 2, 3)->save(file);
  const std::string refusal = "The index file " + file.string() +
                              " was built for another mesh or with other gaps bridged, or the mesh was "
                              "edited since; build the index again.";
  Soup moved = soup;
  moved.positions[17][1] = std::nextafter(moved.positions[17][1], 2.0);
  EXPECT_EQ(loading(file, test::make_mesh(moved)), refusal) << "one vertex moved by one digit";
  Soup turned = soup;
  std::swap(turned.faces[3][0], turned.faces[3][1]);
  EXPECT_EQ(loading(file, test::make_mesh(turned)), refusal) << "one face turned over";
  EXPECT_EQ(loading(file, test::make_mesh(test::with_isolated_vertex(soup, {0, 0, 0}))), refusal);
  EXPECT_EQ(loading(file, test::make_mesh(test::icosphere(1))), refusal);
  EXPECT_EQ(loading(file, test::make_mesh(soup)), "loaded");
}

}  // namespace
}  // namespace vorogeo
