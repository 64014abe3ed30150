// Sizes of both forms from the layout.
#include "index/memory_budget.h"

#include <limits>
#include <string>

#include "support/error.h"

namespace vorogeo {

namespace {

constexpr std::int64_t bytes_per_mib = 1 << 20;

}  // namespace

std::int64_t table_bytes(const PatchLayer& layer) {
  return static_cast<std::int64_t>(layer.table_begin.back() * sizeof(layer.table[0]) +
                                   layer.patch_count * (sizeof(layer.scale[0]) + sizeof(layer.complete[0])));
}

std::int64_t transit_bytes(const PatchLayer& first, bool entries_in_file) {
  const auto count = static_cast<std::int64_t>(first.node_count());
  const auto entries = static_cast<std::int64_t>(sizeof(TransitTable::infinite_entry)) * count * count;
  return transit_table_bytes(first) - (entries_in_file ? entries : 0);
}

std::int64_t MemoryBudget::mib() const {
  if (options_.memory_budget != 0) return options_.memory_budget;
  return tables_in_file_ ? std::numeric_limits<std::int64_t>::max() : default_memory_budget;
}

bool MemoryBudget::fits(std::int64_t bytes) const {
  return (bytes + bytes_per_mib - 1) / bytes_per_mib <= mib();
}

void MemoryBudget::refuse(std::int64_t bytes, const char* comparison) const {
  std::string advice = "give a larger memory budget";
  if (options_.form != IndexForm::tables) {
    advice +=
        options_.delta > 0.0 ? " or a larger delta" : ", or a delta above 0, which makes the graph smaller";
  }
  throw InvalidInput(
      "The memory budget is " + std::to_string(mib()) + " MiB, but the index of this mesh takes " +
      comparison + " " + std::to_string((bytes + bytes_per_mib - 1) / bytes_per_mib) + " MiB" +
      (options_.form == IndexForm::tables ? "" : " in its smallest form") + ": " + advice + ".");
}

IndexForm MemoryBudget::form_of(const IndexData& data) const {
  const std::int64_t landmarks = static_cast<std::int64_t>(sizeof(Landmarks::Row)) * data.second.node_count();
  auto in_memory = [&](std::int64_t bytes) { return tables_in_file_ ? 0 : bytes; };
  const std::int64_t both =
      data.bytes() + in_memory(table_bytes(data.second) + table_bytes(data.first)) + landmarks;
  const std::int64_t tables = both + transit_bytes(data.first, tables_in_file_) + access_bounds_bytes(data);
  if (options_.form == IndexForm::tables) {
    if (!fits(tables)) refuse(tables, "at least");
    return IndexForm::tables;
  }
  if (options_.form == IndexForm::automatic && options_.delta == 0.0 && fits(tables))
    return IndexForm::tables;
  if (!fits(both)) refuse(both, "more than");
  return IndexForm::graph;
}

void MemoryBudget::require(std::int64_t bytes) const {
  if (!fits(bytes)) refuse(bytes, "at least");
}

}  // namespace vorogeo
