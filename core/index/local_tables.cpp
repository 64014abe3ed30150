// The tables of a layer: by exact runs from its nodes, or composed from those of the layer below.
#include "index/local_tables.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "exact/local_solver.h"
#include "index/boundary_dijkstra.h"
#include "index/index_data.h"
#include "index/index_file.h"
#include "index/index_options.h"
#include "index/scans.h"
#include "patches/halo.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Parts of a table are marked as written after their contents are

namespace {

/// Memory of a space that is not in a file.
struct OwnMemory {
  OwnMemory(std::size_t entry_count, std::size_t part_count)
      : entries(new std::uint16_t[entry_count]), parts(part_count) {}
  std::unique_ptr<std::uint16_t[]> entries;
  std::vector<PartRecord> parts;
};

std::uint64_t checksum_of(TableSpace::Contents contents) {
  std::uint64_t sum = 0;
  for (const auto& piece : contents) sum = std::rotl(sum, 1) ^ block_checksum(piece);
  return sum;
}

}  // namespace

TableSpace::TableSpace(std::size_t entries, std::size_t parts) {
  auto memory = std::make_shared<OwnMemory>(entries, parts);
  entries_ = {memory->entries.get(), entries};
  parts_ = memory->parts;
  owner_ = std::move(memory);
}

TableSpace::TableSpace(std::span<std::uint16_t> entries, std::span<PartRecord> parts,
                       std::shared_ptr<const void> owner)
    : entries_(entries), parts_(parts), owner_(std::move(owner)), in_file_(true) {}

bool TableSpace::holds(std::size_t part, Contents contents) const {
  PartRecord& record = parts_[part];
  if (record.filled == 1 && in_file_ && checksum_of(contents) == record.checksum) return true;
  record.filled = 0;
  return false;
}

void TableSpace::note_filled(std::size_t part, Contents contents, TableScale scale, bool complete) const {
  PartRecord& record = parts_[part];
  if (in_file_) record.checksum = checksum_of(contents);
  record.scale = scale;
  record.complete = complete ? 1 : 0;
  std::atomic_thread_fence(std::memory_order_release);
  record.filled = 1;
}

// ---- From distances in single precision to entries of 15 bits

namespace {

constexpr float no_distance = std::numeric_limits<float>::infinity();
/// Columns between two checkpoints: those of a large first-layer patch take a microsecond each.
constexpr Index columns_per_checkpoint = 256;

}  // namespace

TableDraft::TableDraft(const PatchLayer& layer, Index patch)
    : rows_(layer.border_size(patch)),
      columns_(layer.member_count(patch)),
      value_(static_cast<std::size_t>(rows_) * columns_, no_distance) {}

void TableDraft::make_symmetric() {
  for (Index i = 0; i < rows_; ++i) {
    if (i % columns_per_checkpoint == 0) checkpoint();
    line(i)[i] = 0.0f;
    for (Index j = 0; j < i; ++j) {
      float& forth = line(i)[j];
      float& back = line(j)[i];
      forth = back = std::min(forth, back);
    }
  }
}

void TableDraft::close() {
  // Floyd-Warshall; the border nodes are the first columns.
  for (Index by = 0; by < rows_; ++by) {
    checkpoint();
    const float* onward = line(by);
    for (Index column = 0; column < columns_; ++column) {
      if (column != by) relax_by_sums(onward, line(column)[by], rows_, line(column));
    }
  }
}

float TableDraft::greatest_of(Index column) {
  const float* from = line(column);
  float greatest = 0.0f;
  for (Index row = 0; row < rows_; ++row) {
    if (from[row] < no_distance) greatest = std::max(greatest, from[row]);
  }
  return greatest;
}

float TableDraft::set_offsets(TableOrder order, std::vector<float>& offset) {
  float greatest = 0.0f;
  for (Index row = 0; row < rows_; ++row) greatest = std::max(greatest, greatest_of(row));
  const float far = order == TableOrder::tiles ? PatchLayer::far_per_border * greatest : no_distance;
  for (Index column = rows_; column < columns_; ++column) {
    if (column % columns_per_checkpoint == 0) checkpoint();
    const float own = greatest_of(column);
    if (own <= far) {
      greatest = std::max(greatest, own);
      continue;
    }
    offset.resize(columns_, 0.0f);
    float* from = line(column);
    const float least = *std::min_element(from, from + rows_);
    offset[column] = least;
    for (Index row = 0; row < rows_; ++row) from[row] -= least;
  }
  return greatest;
}

bool TableDraft::has_small_part(float greatest) {
  const float within = small_part * greatest;
  const float least = least_steps / PatchLayer::greatest_entry * greatest;
  std::vector<int> near(rows_, 0);
  for (Index column = 0; column < columns_; ++column) {
    const float* from = line(column);
    for (Index row = 0; row < rows_; ++row) near[row] += from[row] > 0.0f && from[row] <= within ? 1 : 0;
    // Rounding could shorten a path over several such entries by any part of it.
    if (column < rows_ && std::any_of(from, from + rows_, [&](float d) { return d > 0.0f && d < least; })) {
      return true;
    }
  }
  return std::ranges::any_of(near, [](int count) { return count >= least_small_part; });
}

TableDraft::Units TableDraft::write(TableOrder order, std::uint16_t* table) {
  Units units;
  const float greatest = set_offsets(order, units.offset);
  units.scale = has_small_part(greatest) ? TableScale::graded(greatest, PatchLayer::greatest_entry)
                                         : TableScale::even(greatest, PatchLayer::greatest_entry);
  const auto rows = static_cast<std::size_t>(rows_);
  const Index width = width_of(order);
  // Columns behind the last member pad the last tile.
  for (Index column = 0; column < (columns_ + width - 1) / width * width; ++column) {
    if (column % columns_per_checkpoint == 0) checkpoint();
    std::uint16_t* to = table + column / width * rows * width + column % width;
    const float* from = column < columns_ ? line(column) : nullptr;
    for (std::size_t row = 0; row < rows; ++row, to += width) {
      if (from != nullptr && from[row] < no_distance) {
        *to = units.scale.entry(from[row], PatchLayer::greatest_entry);
      } else {
        *to = PatchLayer::infinite_entry;
        units.complete = units.complete && from == nullptr;
      }
    }
  }
  return units;
}

std::size_t draft_bytes(const PatchLayer& layer, Index patch) {
  return sizeof(float) * layer.border_size(patch) * layer.member_count(patch);
}

void set_units(PatchLayer& layer, Index patch, const TableDraft::Units& units) {
  layer.scale[patch] = units.scale;
  layer.complete[patch] = units.complete ? 1 : 0;
  if (units.offset.empty()) return;
  layer.offset.resize(layer.member.element.size(), 0.0f);
  std::ranges::copy(units.offset, layer.offset.begin() + layer.member.begin[patch]);
}

void note_complete(PatchLayer& layer) {
  layer.complete.assign(layer.patch_count, 1);
  for (Index p = 0; p < layer.patch_count; ++p) {
    std::size_t infinite_count = 0;
    for (std::size_t i = layer.table_begin[p]; i < layer.table_begin[p + 1]; ++i) {
      infinite_count += layer.table[i] == PatchLayer::infinite_entry ? 1 : 0;
    }
    // Without the columns that pad the last tile.
    const std::size_t filled = static_cast<std::size_t>(layer.border_size(p)) * layer.member_count(p);
    layer.complete[p] = infinite_count == table_size(layer, p) - filled ? 1 : 0;
  }
}

// ---- The wave over the patches, and the last step of each

namespace {

/// Positions of the patches in a breadth-first order over touching patches.
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
      for (Index next : layer.touching[wave[at]]) reach(next);
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

TableFiller::TableFiller(PatchLayer& layer, TableSpace space, std::span<const Index> groups, Closure closure,
                         int threads, const Progress& progress)
    : layer_(layer),
      space_(std::move(space)),
      groups_(groups),
      closure_(closure),
      missing_(layer.patch_count),
      drafts_(layer.patch_count) {
  layer.scale.assign(layer.patch_count, {});
  layer.complete.assign(layer.patch_count, 1);
  layer.offset.clear();
  std::vector<std::uint8_t> held(layer.patch_count, 0);
  const Index in_file = space_.in_file() ? layer.patch_count : 0;
  parallel_for(in_file, threads, progress, "Checking the tables that are there", [&](std::size_t p, int) {
    const std::span<const std::byte> contents = std::as_bytes(entries_of(static_cast<Index>(p)));
    if (!space_.holds(p, {&contents, 1})) return;
    held[p] = 1;
    layer.scale[p] = space_.part(p).scale;
    layer.complete[p] = space_.part(p).complete == 1 ? 1 : 0;
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
  return space_.entries().subspan(layer_.table_begin[patch],
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
  // Records hold no offsets: a build that goes on solves the few patches with outliers again.
  if (units.offset.empty()) {
    const std::span<const std::byte> contents = std::as_bytes(entries);
    space_.note_filled(patch, {&contents, 1}, units.scale, units.complete);
  }
  const std::lock_guard lock(setting_);
  set_units(layer_, patch, units);
}

// ---- Exact runs from the border nodes of all patches

namespace {

constexpr Index nodes_per_group = 16;

/// From so many groups of nodes, or up to twice as many, the cost of all runs is estimated.
constexpr std::size_t groups_to_estimate = 8;
/// Shorter builds need no warning.
constexpr double least_seconds = 1.0;

/// A merged window deviates by at most this fraction of its face and its distance, on average by far less:
/// the tables resolve some 3e-4 of an edge.
constexpr double merge_tolerance = 2e-4;

/// Solves from the nodes between the same patches, which share one halo.
class GroupSolver {
 public:
  explicit GroupSolver(const IndexData& data)
      : surface_(data.surface),
        layer_(data.second),
        solver_(data.geometry),
        halo_(*data.surface.mesh, data.first_face) {}

  void reset(std::span<const PatchRow> patches) {
    patches_.clear();
    for (const PatchRow& at : patches) patches_.push_back(at.patch);
    halo_.surround(patches_, table_growth);
    targets_.clear();
    for (Index p : patches_) targets_.add(surface_, layer_.members(p));
  }

  void solve(Index node) {
    const ExactSource source{surface_.surface_point(layer_.node_place[node])};
    ExactLimits limits;
    limits.face_allowed = halo_.mask();
    limits.targets = targets_.vertices;
    limits.edge_targets = targets_.points;
    // Windows behind the front are kept: dropping them takes 3 to 7 % longer on the few faces of a patch.
    limits.merge_tolerance = merge_tolerance;
    solver_.run(std::span(&source, 1), limits);
  }

  /// Distance from the node that was solved last.
  double distance(Index place) const {
    return surface_.at_place(place, [&](const auto& target) { return solver_.distance(target); });
  }

 private:
  const InnerSurface& surface_;
  const PatchLayer& layer_;
  LocalSolver solver_;
  Halo halo_;
  std::vector<Index> patches_;
  PlaceTargets targets_;
};

constexpr const char* table_phase = "Computing exact distances inside patches";

/// Warns if all runs will take as long as many exact fields of the mesh; returns how many then, otherwise 0.
/// Takes some half a percent of their time.
double warn_of_dear_tables(const std::shared_ptr<const LocalGeometry>& geometry, double seconds,
                           const Progress& progress) {
  if (seconds < least_seconds) return 0.0;
  const FieldTiming field = time_exact_field(geometry, seconds / fields_to_warn, progress, table_phase);
  if (!field.is_complete || field.seconds <= 0.0 || field.seconds > seconds / fields_to_warn) return 0.0;
  const double fields = seconds / field.seconds;
  auto rounded = [](double value) {
    std::ostringstream text;
    text << std::setprecision(value < 100.0 ? 2 : 9) << (value < 100.0 ? value : std::round(value));
    return text.str();
  };
  progress.warn("Building this index will take about " + rounded(seconds) + " s of one core, as long as " +
                std::to_string(std::lround(fields)) + " exact fields of this mesh (" +
                rounded(1000.0 * field.seconds) + " ms each): for fewer fields, take the exact method.");
  return fields;
}

}  // namespace

double expected_table_seconds(const IndexData& data, const Progress& progress) {
  const PatchLayer& layer = data.second;
  const std::vector<Index> groups = group_by_patches(layer, nodes_per_group);
  GroupSolver solver(data);
  const std::size_t count = groups.size() - 1;
  const std::size_t step = std::max<std::size_t>(1, count / groups_to_estimate);
  double seconds = 0.0;
  Index nodes = 0;
  for (std::size_t group = step / 2; group < count; group += step) {
    progress.report(0.0, table_phase);
    const Index first = groups[group], last = groups[group + 1] - 1;
    const double begin = thread_seconds();
    solver.reset(layer.patches_of(first));
    solver.solve(first);
    const double middle = thread_seconds();
    seconds += middle - begin;
    if (last > first) {
      // The first run of a group brings its faces into the caches.
      solver.solve(last);
      seconds += (last - first) * (thread_seconds() - middle);
    }
    nodes += last - first + 1;
  }
  return nodes == 0 ? 0.0 : seconds * layer.node_count() / nodes;
}

std::int64_t local_draft_bytes(const PatchLayer& layer) {
  return greatest_draft_bytes(layer, group_by_patches(layer, nodes_per_group));
}

double fill_local_tables(IndexData& data, const TableSpace& space, int threads, const Progress& progress) {
  PatchLayer& layer = data.second;
  // Small groups, so that progress is steady and all threads have work even when there are few patches.
  const std::vector<Index> groups = group_by_patches(layer, nodes_per_group);
  const Progress before = progress.part(0.005, 0.01);
  TableFiller tables(layer, space, groups, TableFiller::Closure::closed, threads, progress.part(0.0, 0.005));
  PerWorker<GroupSolver> solvers(threads);
  double fields = 0.0;
  if (!tables.left().empty()) {
    fields = warn_of_dear_tables(data.geometry, expected_table_seconds(data, before), before);
  }
  tables.fill(threads, progress, 0.01, table_phase, [&](Index group, int worker) {
    GroupSolver& solver = solvers.of(worker, data);
    solver.reset(layer.patches_of(groups[group]));
    for (Index node = groups[group]; node < groups[group + 1]; ++node) {
      checkpoint();
      solver.solve(node);
      tables.put_rows(node, [&](Index place) { return solver.distance(place); });
    }
  });
  return fields;
}

// ---- Composition of first-layer tables

std::int64_t composed_draft_bytes(const PatchLayer& first) {
  return greatest_draft_bytes(first, group_by_patches(first, nodes_per_leader));
}

void compose_tables(IndexData& data, const TableSpace& space, int threads, const Progress& progress) {
  PatchLayer& first = data.first;
  const PatchLayer& second = data.second;
  constexpr const char* phase = "Composing first-layer tables";
  struct Scratch {
    explicit Scratch(const PatchLayer& layer) : batch(layer) {}
    BatchDijkstra batch;
    std::vector<Index> sources;
    std::vector<std::uint8_t> allowed;
  };
  const std::vector<Index> led = group_by_patches(first, nodes_per_leader);
  TableFiller tables(first, space, led, TableFiller::Closure::symmetric, threads, progress.part(0.0, 0.05));
  PerWorker<Scratch> scratch(threads);
  tables.fill(threads, progress, 0.05, phase, [&](Index leader, int worker) {
    Scratch& own = scratch.of(worker, second);
    const auto patches = first.patches_of(led[leader]);
    own.allowed.assign(second.patch_count, 0);
    for (const PatchRow& at : patches) {
      for (Index p : data.children(at.patch)) {
        own.allowed[p] = 1;
        for (Index other : second.touching[p]) own.allowed[other] = 1;
      }
    }
    own.sources.clear();
    for (Index node = led[leader]; node < led[leader + 1]; ++node) {
      own.sources.push_back(second.place_node[first.node_place[node]]);
    }
    own.batch.search_from_each(own.sources, own.allowed, [&](std::size_t i) {
      tables.put_rows(led[leader] + static_cast<Index>(i),
                      [&](Index place) { return own.batch.distance(second.place_node[place]); });
    });
  });
}

}  // namespace vorogeo
