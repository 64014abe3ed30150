// Building an index, phase by phase.
#include "index/geodesic_index.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <string>

#include "index/border_pieces.h"
#include "index/build_cost.h"
#include "index/index_data.h"
#include "index/index_file.h"
#include "index/local_tables.h"
#include "mesh/mesh.h"
#include "support/error.h"
#include "support/memory.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

const char* to_string(IndexForm form) { return form == IndexForm::tables ? "tables" : "graph"; }

namespace {

constexpr const char* memory_advice =
    "Close other programs, use fewer threads, or build the index of a smaller mesh.";

/// Bytes that patches and the inner surface take per vertex of the mesh.
constexpr double layout_bytes = 1000.0;

void require_memory_for_layout(const Mesh& mesh) {
  require_memory(layout_bytes * mesh.vertex_count(), 0, "Laying out the patches of this mesh", memory_advice);
}

/// For tables that are not in a file, and for drafts of those not yet written.
void require_memory_for_tables(const IndexData& data, IndexForm form, bool in_file) {
  std::int64_t bytes = std::max(local_draft_bytes(data.second), composed_draft_bytes(data.first));
  if (!in_file) bytes += table_bytes(data.second) + table_bytes(data.first);
  if (form == IndexForm::tables) bytes += transit_bytes(data.first, in_file) + access_bounds_bytes(data);
  require_memory(static_cast<double>(bytes), 0, "Building the tables of this index", memory_advice);
}

/// An index with its mesh and its head, after mesh and options are checked.
std::unique_ptr<IndexData> begin_data(std::shared_ptr<const Mesh> mesh, const IndexOptions& options,
                                      const Progress& progress) {
  require_buildable(*mesh, options);
  auto data = std::make_unique<IndexData>();
  data->mesh = std::move(mesh);
  const Watch watch(progress, "Reading the mesh");
  data->head.fingerprint = fingerprint_of(*data->mesh);
  data->head.delta = options.delta;
  data->head.numbers = {options.seed,
                        0,
                        0,
                        static_cast<std::uint64_t>(options.first_layer_patches),
                        static_cast<std::uint64_t>(options.second_layer_patches),
                        0};
  return data;
}

/// Delta divided by the mean number of second-layer patches in a first-layer patch: a route passes about so
/// many times fewer first-layer arcs than second-layer patches, so pruning adds less than delta on average.
double delta_of_arcs(const IndexData& data, double delta) {
  return delta * std::max<Index>(1, data.first.patch_count) / std::max<Index>(1, data.second.patch_count);
}

/// Builds all that begin_data() does not. `file`: where the tables are filled; null: in memory.
void fill_data(IndexData& data, const IndexOptions& options, BuildFile* file, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const double filled = file != nullptr ? 0.99 : 1.0;  // the rest is for writing the file
  require_memory_for_layout(*data.mesh);
  data.partition = partition_for_index(
      *data.mesh, {options.first_layer_patches, options.second_layer_patches, options.seed, options.threads},
      progress.part(0.01, 0.07));
  data.lay_out(options.threads, progress.part(0.07, 0.1));
  const MemoryBudget budget(options, file != nullptr);
  const IndexForm form = budget.form_of(data);
  data.head.numbers[IndexHead::pairs] =
      static_cast<std::uint64_t>(pairs_of_nodes(data.first) + pairs_of_nodes(data.second));
  data.head.numbers[IndexHead::form] = form == IndexForm::graph ? 1 : 0;
  data.head.numbers[IndexHead::layout] = checksum_of_layout(data);
  require_memory_for_tables(data, form, file != nullptr);
  TableSpaces spaces;
  {
    const Watch watch(progress.part(0.1, 0.1), "Taking room for the tables");
    spaces = file != nullptr ? file->spaces(data) : spaces_in_memory(data);
  }
  data.statistics.expected_fields =
      fill_local_tables(data, spaces.second, options.threads, progress.part(0.1, 0.8));
  compose_tables(data, spaces.first, options.threads, progress.part(0.8, 0.85));
  if (form == IndexForm::tables) {
    data.transit_table =
        make_transit_table(data.first, spaces.transit, options.threads, progress.part(0.85, 0.98));
    data.access_bounds = make_access_bounds(data);
  } else {
    data.graph = make_transit_graph(data.first, delta_of_arcs(data, options.delta), options.threads,
                                    progress.part(0.85, 0.98));
  }
  data.landmarks = make_landmarks(data.second, progress.part(0.98, filled));
  if (form == IndexForm::graph) budget.require(data);
  if (file != nullptr) {
    const Watch watch(progress.part(filled, 1.0), "Writing the index file");
    file->finish(data);
  }
  data.count();
  data.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Turns any failed allocation into an error that says what to do.
template <class Build>
std::shared_ptr<const GeodesicIndex> building(Build&& build) {
  try {
    return build();
  } catch (const std::bad_alloc&) {
    throw NotEnoughMemory(std::string("There is not enough memory to build this index. ") + memory_advice);
  }
}

}  // namespace

std::shared_ptr<const GeodesicIndex> GeodesicIndex::build(std::shared_ptr<const Mesh> mesh,
                                                          const IndexOptions& options,
                                                          const Progress& progress) {
  return building([&] {
    auto data = begin_data(std::move(mesh), options, progress.part(0.0, 0.01));
    fill_data(*data, options, nullptr, progress);
    return std::make_shared<const GeodesicIndex>(std::move(data));
  });
}

std::shared_ptr<const GeodesicIndex> GeodesicIndex::build_in_file(const std::filesystem::path& file,
                                                                  std::shared_ptr<const Mesh> mesh,
                                                                  const IndexOptions& options,
                                                                  const Progress& progress) {
  return building([&]() -> std::shared_ptr<const GeodesicIndex> {
    auto data = begin_data(mesh, options, progress.part(0.0, 0.01));
    std::error_code unknown;  // a file that cannot be looked at cannot be written either, which then says why
    if (std::filesystem::exists(file, unknown)) {
      const Watch watch(progress.part(0.01, 1.0), "Loading the index");
      require_same(file, data->head);
      return load(file, std::move(mesh));
    }
    BuildFile out(file, data->head);
    if (auto complete = out.complete(mesh)) return std::make_shared<const GeodesicIndex>(std::move(complete));
    fill_data(*data, options, &out, progress);
    return std::make_shared<const GeodesicIndex>(std::move(data));
  });
}

GeodesicIndex::GeodesicIndex(std::unique_ptr<IndexData> data) : data_(std::move(data)) {}
GeodesicIndex::~GeodesicIndex() = default;

const std::shared_ptr<const Mesh>& GeodesicIndex::mesh() const { return data_->mesh; }
const Fingerprint& GeodesicIndex::fingerprint() const { return data_->head.fingerprint; }
const IndexStatistics& GeodesicIndex::statistics() const { return data_->statistics; }

std::span<const Index> GeodesicIndex::face_patches(int layer) const {
  if (layer == 1) return data_->partition.first_layer;
  if (layer == 2) return data_->partition.second_layer;
  throw InvalidInput("Layer " + std::to_string(layer) +
                     " does not exist: layers are 1 (large patches) and 2.");
}

}  // namespace vorogeo
