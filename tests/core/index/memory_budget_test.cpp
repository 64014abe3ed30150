// The two forms: which is chosen, that both answer everything, and the refusal of a budget that is too small.
#include "index/memory_budget.h"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/exact_solver.h"
#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

constexpr double mib = 1 << 20;

struct Case {
  std::shared_ptr<const Mesh> mesh = test::make_mesh(test::hills(56, 0.1));
  IndexOptions options;
  Case() {
    options.first_layer_patches = 12;
    options.second_layer_patches = 3;
  }
  std::shared_ptr<const GeodesicIndex> build(std::int64_t budget, double delta = 0.0) {
    options.memory_budget = budget;
    options.delta = delta;
    return GeodesicIndex::build(mesh, options);
  }
  std::string refusal(std::int64_t budget, double delta = 0.0) {
    try {
      build(budget, delta);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "not refused";
  }
};

TEST(MemoryBudget, ChoosesTheForm) {
  Case c;
  const auto tables = c.build(0);
  EXPECT_EQ(tables->statistics().form, IndexForm::tables);
  EXPECT_GT(tables->data().transit_table.count, 0);
  const auto graph = c.build(0, 0.05);
  EXPECT_EQ(graph->statistics().form, IndexForm::graph) << "asked for by delta";
  EXPECT_EQ(graph->data().transit_table.count, 0);
  EXPECT_TRUE(graph->data().first.table.empty());
  EXPECT_LT(graph->statistics().arcs, tables->statistics().arcs);
  EXPECT_LT(graph->statistics().bytes, tables->statistics().bytes);

  // A budget of exactly what the tables take holds them; the predicted sizes are the actual ones.
  const auto needed =
      static_cast<std::int64_t>(std::ceil(static_cast<double>(tables->statistics().bytes) / mib));
  EXPECT_EQ(c.build(needed)->statistics().form, IndexForm::tables);
}

TEST(MemoryBudget, OneThatIsTooSmallIsToldTheLeast) {
  Case c;
  c.options.form = IndexForm::tables;
  const std::string tables = c.refusal(1);
  const auto bytes = static_cast<double>(c.build(0)->statistics().bytes);
  EXPECT_EQ(tables, "The memory budget is 1 MiB, but the index of this mesh takes at least " +
                        std::to_string(static_cast<int>(std::ceil(bytes / mib))) +
                        " MiB: give a larger memory budget.");
  c.options.form = IndexForm::automatic;
  const std::string early = c.refusal(1, 0.05);
  EXPECT_TRUE(early.starts_with("The memory budget is 1 MiB, but the index of this mesh takes more than "))
      << early;
  EXPECT_TRUE(early.ends_with(" MiB in its smallest form: give a larger memory budget or a larger delta."))
      << early;
  EXPECT_EQ(c.refusal(-1), "The memory budget is -1 MiB; give a positive number, or 0 for 4096 MiB.");
  // The least figure suffices, and one less does not.
  const auto least =
      static_cast<std::int64_t>(std::ceil(static_cast<double>(c.build(0, 0.05)->statistics().bytes) / mib));
  EXPECT_EQ(c.build(least, 0.05)->statistics().form, IndexForm::graph);
  EXPECT_NE(c.refusal(least - 1, 0.05).find("takes"), std::string::npos);
}

TEST(MemoryBudget, CountsWhatOfATransitTableIsInNoFile) {
  const auto index = test::make_index(test::hills(30, 0.12), 5, 4);
  const TransitTable& table = index->data().transit_table;
  const std::int64_t rest =
      sizeof(float) * table.least.size() + sizeof(Index) * (table.group_begin.size() + table.group_of.size());
  EXPECT_EQ(transit_bytes(index->data().first, true), rest);
  EXPECT_EQ(transit_bytes(index->data().first, false), rest + 2 * std::int64_t{table.count} * table.count);
}

TEST(MemoryBudget, NamesOfForms) {
  EXPECT_STREQ(to_string(IndexForm::tables), "tables");
  EXPECT_STREQ(to_string(IndexForm::graph), "graph");
}

}  // namespace
}  // namespace vorogeo
