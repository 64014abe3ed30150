// Building an index, phase by phase.
#include "index/geodesic_index.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <string>

#include "index/index_data.h"
#include "index/local_tables.h"
#include "index/memory_budget.h"
#include "index/overlay.h"
#include "index/table_draft.h"
#include "mesh/length_limits.h"
#include "support/checkpoint.h"
#include "support/error.h"
#include "support/memory.h"
#include "support/parallel.h"

namespace vorogeo {

void IndexData::lay_out(int threads, const Progress& progress) {
  {
    const Watch watch(progress.part(0.0, 0.5), "Laying out the patches");
    work = make_work_mesh(*mesh, partition);
  }
  // What the solver needs and what the tables need, in parallel.
  parallel_for(2, threads, progress.part(0.5, 0.8), "Laying out the patches", [&](std::size_t half, int) {
    if (half == 0) {
      auto unfolded = std::make_shared<ExactGeometry>(work.mesh);
      // No path bends at a point inside an edge; as pseudo-sources such points would tie with one another
      // without end.
      for (const WorkMesh::EdgePoint& point : work.edge_points) {
        unfolded->can_bend[point.vertex] = ExactGeometry::never;
      }
      geometry = std::move(unfolded);
    } else {
      second =
          lay_out_patches(*work.mesh, work.second_layer, partition.second_layer_count, {}, TableOrder::tiles);
    }
  });
  const Watch watch(progress.part(0.8, 1.0), "Laying out the patches");
  std::vector<std::uint8_t> is_node(work.mesh->vertex_count());
  for (Index v = 0; v < work.mesh->vertex_count(); ++v) is_node[v] = second.vertex_node[v] != no_index;
  std::vector<Index> first_label(work.second_layer);
  for (Index& label : first_label) label = partition.parent[label];
  first = lay_out_patches(*work.mesh, first_label, partition.first_layer_count, is_node);

  home_patch.assign(work.mesh->vertex_count(), no_index);
  home_column.assign(work.mesh->vertex_count(), no_index);
  for (Index p = 0; p < second.patch_count; ++p) {
    const auto members = second.members(p);
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (home_patch[members[i]] != no_index) continue;
      home_patch[members[i]] = p;
      home_column[members[i]] = static_cast<Index>(i);
    }
  }
  link_layers();
}

std::int64_t IndexData::bytes() const {
  auto of = [](const auto& list) { return list.size() * sizeof(list[0]); };
  return static_cast<std::int64_t>(
      first.memory_bytes() + second.memory_bytes() + graph.memory_bytes() + transit_table.memory_bytes() +
      access_bounds.memory_bytes() + work.mesh->memory_bytes() + geometry->memory_bytes() +
      of(work.work_vertex) + of(work.user_vertex) + of(work.second_layer) + of(work.user_face) +
      of(work.edge_points) + of(partition.first_layer) + of(partition.second_layer) + of(partition.parent) +
      of(parent_column) + of(home_patch) + of(home_column) + of(first_face) + of(first_child) +
      of(second_node) + of(node_position));
}

void IndexData::count() {
  statistics.vertices = mesh->vertex_count();
  statistics.faces = mesh->face_count();
  statistics.components = mesh->component_count();
  statistics.first_layer_patches = first.patch_count;
  statistics.second_layer_patches = second.patch_count;
  statistics.first_layer_border_vertices = first.node_count();
  statistics.second_layer_border_vertices = second.node_count();
  statistics.form = form();
  statistics.arcs_before_pruning = graph.arcs_before_pruning;
  statistics.arcs =
      graph.has_arcs() ? static_cast<std::int64_t>(graph.arc.size() / 2) : graph.arcs_before_pruning;
  statistics.bytes = bytes();
}

const char* to_string(IndexForm form) {
  switch (form) {
    case IndexForm::automatic:
      return "automatic";
    case IndexForm::tables:
      return "tables";
    case IndexForm::graph:
      return "graph";
  }
  return "unknown";
}

namespace {

constexpr const char* memory_advice =
    "Close other programs, use fewer threads, or build the index of a smaller mesh.";

/// While they are computed, tables hold single precision, twice as large as in the end.
void require_memory_for_tables(const IndexData& data) {
  const std::int64_t second = table_bytes(data.second);
  const std::int64_t first = table_bytes(data.first);
  require_memory(static_cast<double>(second + first + 2 * std::max(second, first)), 0,
                 "Building the tables of this index", memory_advice);
}

std::unique_ptr<IndexData> build_data(std::shared_ptr<const Mesh> mesh, const IndexOptions& options,
                                      const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (!(options.delta >= 0.0 && options.delta < 1.0)) {
    throw InvalidInput("delta is " + std::to_string(options.delta) +
                       "; it must be at least 0 (nothing lost) and below 1.");
  }
  if (options.memory_budget < 0) {
    throw InvalidInput("The memory budget is " + std::to_string(options.memory_budget) +
                       " MiB; give a positive number, or 0 for " + std::to_string(default_memory_budget) +
                       " MiB.");
  }
  require_lengths(*mesh, "an index takes", index_lengths.least_mean, index_lengths.greatest);
  auto data = std::make_unique<IndexData>();
  data->mesh = std::move(mesh);
  {
    const Watch watch(progress.part(0.0, 0.01), "Reading the mesh");
    data->fingerprint = fingerprint_of(*data->mesh);
  }
  data->statistics.delta = options.delta;
  data->statistics.seed = options.seed;
  data->partition = make_partition(
      *data->mesh, {options.first_layer_patches, options.second_layer_patches, options.seed, options.threads},
      progress.part(0.01, 0.07));
  data->lay_out(options.threads, progress.part(0.07, 0.1));
  const MemoryBudget budget(options);
  const IndexForm form = budget.form_of(*data);
  require_memory_for_tables(*data);
  data->statistics.expected_fields =
      fill_local_tables(make_table_surface(*data->mesh, data->work, data->geometry), data->work, data->second,
                        options.threads, progress.part(0.1, 0.8));
  compose_tables(data->second, data->partition.parent, data->first, options.threads,
                 progress.part(0.8, 0.85));
  if (form == IndexForm::tables) {
    data->transit_table = make_transit_table(data->first, options.threads, progress.part(0.85, 0.98));
    data->access_bounds = make_access_bounds(*data);
    data->graph = make_landmarks(data->second, data->first, progress.part(0.98, 1.0));
  } else {
    data->graph = make_search_graph(data->second, data->first, data->partition.parent, options.delta,
                                    options.threads, progress.part(0.85, 1.0));
    drop_tables(data->first);
    budget.require(data->bytes());
  }
  data->count();
  data->statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return data;
}

}  // namespace

std::shared_ptr<const GeodesicIndex> GeodesicIndex::build(std::shared_ptr<const Mesh> mesh,
                                                          const IndexOptions& options,
                                                          const Progress& progress) {
  try {
    return std::make_shared<const GeodesicIndex>(build_data(std::move(mesh), options, progress));
  } catch (const std::bad_alloc&) {
    throw NotEnoughMemory(std::string("There is not enough memory to build this index. ") + memory_advice);
  }
}

GeodesicIndex::GeodesicIndex(std::unique_ptr<IndexData> data) : data_(std::move(data)) {}
GeodesicIndex::~GeodesicIndex() = default;

const std::shared_ptr<const Mesh>& GeodesicIndex::mesh() const { return data_->mesh; }
const Fingerprint& GeodesicIndex::fingerprint() const { return data_->fingerprint; }
const IndexStatistics& GeodesicIndex::statistics() const { return data_->statistics; }

std::span<const Index> GeodesicIndex::face_patches(int layer) const {
  if (layer == 1) return data_->partition.first_layer;
  if (layer == 2) return data_->partition.second_layer;
  throw InvalidInput("Layer " + std::to_string(layer) +
                     " does not exist: layers are 1 (large patches) and 2.");
}

}  // namespace vorogeo
