// The wave over the patches, and the last step of each.
#include "index/table_filler.h"

#include <algorithm>
#include <numeric>

#include "support/parallel.h"

namespace vorogeo {

namespace {

/// Places of the patches in a breadth-first order over touching patches.
std::vector<Index> places_in_wave(const PatchLayer& layer) {
  std::vector<Index> place(layer.patch_count, no_index);
  std::vector<Index> wave;
  wave.reserve(layer.patch_count);
  auto reach = [&](Index patch) {
    if (place[patch] != no_index) return;
    place[patch] = static_cast<Index>(wave.size());
    wave.push_back(patch);
  };
  for (Index first = 0; first < layer.patch_count; ++first) {
    reach(first);
    for (std::size_t at = wave.size() - 1; at < wave.size(); ++at) {
      for (Index next : layer.touching.of(wave[at])) reach(next);
    }
  }
  return place;
}

/// The groups in the order of the first of their patches in the wave.
std::vector<Index> groups_in_wave(const PatchLayer& layer, std::span<const Index> groups) {
  const std::vector<Index> place = places_in_wave(layer);
  std::vector<Index> first(groups.size() - 1, no_index);
  for (std::size_t g = 0; g + 1 < groups.size(); ++g) {
    for (const PatchRow& at : layer.patches_of(groups[g])) {
      if (first[g] == no_index || place[at.patch] < first[g]) first[g] = place[at.patch];
    }
  }
  std::vector<Index> order(first.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Index g) { return first[g]; });
  return order;
}

}  // namespace

std::int64_t greatest_draft_bytes(const PatchLayer& layer, std::span<const Index> groups) {
  std::vector<Index> missing(layer.patch_count, 0);
  std::vector<std::uint8_t> begun(layer.patch_count, 0);
  const std::vector<Index> order = groups_in_wave(layer, groups);
  for (Index group : order) {
    for (const PatchRow& at : layer.patches_of(groups[group])) ++missing[at.patch];
  }
  std::int64_t bytes = 0;
  std::int64_t greatest = 0;
  for (Index group : order) {
    for (const PatchRow& at : layer.patches_of(groups[group])) {
      if (begun[at.patch] == 0) bytes += static_cast<std::int64_t>(draft_bytes(layer, at.patch));
      begun[at.patch] = 1;
    }
    greatest = std::max(greatest, bytes);
    for (const PatchRow& at : layer.patches_of(groups[group])) {
      if (--missing[at.patch] == 0) bytes -= static_cast<std::int64_t>(draft_bytes(layer, at.patch));
    }
  }
  return greatest;
}

TableFiller::TableFiller(PatchLayer& layer, TableRoom room, std::span<const Index> groups, Closure closure,
                         int threads, const Progress& progress)
    : layer_(layer),
      room_(std::move(room)),
      groups_(groups),
      closure_(closure),
      missing_(layer.patch_count),
      drafts_(layer.patch_count) {
  layer.scale.assign(layer.patch_count, {});
  layer.complete.assign(layer.patch_count, 1);
  layer.offset.clear();
  std::vector<std::uint8_t> held(layer.patch_count, 0);
  const Index in_file = room_.in_file() ? layer.patch_count : 0;
  parallel_for(in_file, threads, progress, "Checking the tables that are there", [&](std::size_t p, int) {
    const std::span<const std::byte> contents = std::as_bytes(entries_of(static_cast<Index>(p)));
    if (!room_.holds(p, {&contents, 1})) return;
    held[p] = 1;
    layer.scale[p] = room_.part(p).scale;
    layer.complete[p] = room_.part(p).complete == 1 ? 1 : 0;
  });
  for (Index group : groups_in_wave(layer, groups)) {
    bool wanted = false;
    for (const PatchRow& at : layer.patches_of(groups[group])) {
      if (held[at.patch] != 0) continue;
      ++missing_[at.patch];
      wanted = true;
    }
    if (wanted) left_.push_back(group);
  }
}

std::span<std::uint16_t> TableFiller::entries_of(Index patch) const {
  return room_.entries().subspan(layer_.table_begin[patch],
                                 layer_.table_begin[patch + 1] - layer_.table_begin[patch]);
}

void TableFiller::begin(Index group) {
  const std::lock_guard lock(making_);
  for (const PatchRow& at : layer_.patches_of(groups_[group])) {
    if (missing_[at.patch] > 0 && !drafts_[at.patch]) {
      drafts_[at.patch] = std::make_unique<TableDraft>(layer_, at.patch);
    }
  }
}

void TableFiller::finish(Index group) {
  for (const PatchRow& at : layer_.patches_of(groups_[group])) {
    if (drafts_[at.patch] && --missing_[at.patch] == 0) write(at.patch);
  }
}

void TableFiller::write(Index patch) {
  TableDraft& draft = *drafts_[patch];
  draft.make_symmetric();
  if (closure_ == Closure::closed) draft.close();
  const std::span<std::uint16_t> entries = entries_of(patch);
  const TableDraft::Units units = draft.write(layer_.order, entries.data());
  drafts_[patch].reset();
  // Offsets are not kept in a record: the few patches with outliers are solved again.
  if (units.offset.empty()) {
    const std::span<const std::byte> contents = std::as_bytes(entries);
    room_.note_filled(patch, {&contents, 1}, units.scale, units.complete);
  }
  const std::lock_guard lock(setting_);
  set_units(layer_, patch, units);
}

}  // namespace vorogeo
