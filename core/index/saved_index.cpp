// Which parts of an index go into its file, and the checks that tie a file to a mesh.
#include "index/saved_index.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "index/geodesic_index.h"
#include "index/index_data.h"
#include "index/index_file.h"
#include "index/table_draft.h"

namespace vorogeo {

namespace {

/// Distances must be numbers of at least 0; infinity is what a patch cannot reach.
template <class T>
void require_distances(IndexFileReader& in, const std::vector<T>& values) {
  for (T value : values) {
    if (!(value >= T(0))) in.fail("is damaged (a distance is negative or NaN)");
  }
}

void require_scale(IndexFileReader& in, TableScale scale) {
  if (!std::isfinite(scale.unit())) in.fail("is damaged (the unit of a table is infinite or NaN)");
}

using Entries = SharedArray<std::uint16_t>;

Entries read_entries(IndexFileReader& in, TableStorage storage) {
  return storage == TableStorage::mapped ? in.mapped_block<std::uint16_t>()
                                         : Entries(in.block<std::uint16_t>());
}

/// The table of a layer; empty in an index without one.
void load_table(IndexFileReader& in, PatchLayer& layer, TableStorage storage) {
  layer.table = read_entries(in, storage);
  if (layer.table.size() != layer.table_begin.back()) in.fail("is damaged (a block has the wrong size)");
  std::uint16_t bits = 0;
  for (std::uint16_t entry : layer.table) bits |= entry;
  static_assert(std::has_single_bit(PatchLayer::infinite_entry + 1U));
  if (bits > PatchLayer::infinite_entry) {
    in.fail("is damaged (a distance is greater than its table can hold)");
  }
  note_complete(layer);
}

void load_units(IndexFileReader& in, PatchLayer& layer) {
  layer.scale = in.block<TableScale>(layer.patch_count);
  for (const TableScale scale : layer.scale) require_scale(in, scale);
  layer.offset = in.block<float>();
  if (!layer.offset.empty() && layer.offset.size() != layer.member.size()) {
    in.fail("is damaged (the offsets of a layer have the wrong size)");
  }
  require_distances(in, layer.offset);
}

void load_transit_units(IndexFileReader& in, TransitTable& table, const PatchLayer& first, Entries entry) {
  auto least = in.block<float>();
  const auto scale = in.block<TableScale>(1);
  require_distances(in, least);
  require_scale(in, scale[0]);
  if (first.node_count() == 0 && entry.empty() && least.empty()) return;
  TransitTable laid_out = group_nodes(first);
  const auto count = static_cast<std::size_t>(laid_out.count);
  const auto groups = static_cast<std::size_t>(laid_out.group_count());
  if (entry.size() != count * count || least.size() != groups * groups) {
    in.fail("is damaged (the table of borders has the wrong size)");
  }
  table = std::move(laid_out);
  table.entry = std::move(entry);
  table.least = std::move(least);
  table.scale = scale[0];
}

/// Every patch from 0 to count - 1 owns a face, and no face has any other label.
void require_labels(IndexFileReader& in, const std::vector<Index>& label, Index count) {
  std::vector<std::uint8_t> used(std::max<Index>(count, 0), 0);
  for (Index patch : label) {
    if (patch < 0 || patch >= count) in.fail("is damaged (a face has no patch)");
    used[patch] = 1;
  }
  if (std::find(used.begin(), used.end(), 0) != used.end()) in.fail("is damaged (a patch has no face)");
}

void load_partition(IndexFileReader& in, Partition& partition, Index faces) {
  partition.first_layer = in.block<Index>(faces);
  partition.second_layer = in.block<Index>(faces);
  partition.parent = in.block<Index>();
  if (partition.parent.size() > static_cast<std::size_t>(faces))
    in.fail("is damaged (more patches than faces)");
  partition.second_layer_count = static_cast<Index>(partition.parent.size());
  for (Index parent : partition.parent) {
    if (parent < 0 || parent > faces) in.fail("is damaged (a patch has no parent)");
    partition.first_layer_count = std::max(partition.first_layer_count, parent + 1);
  }
  require_labels(in, partition.first_layer, partition.first_layer_count);
  require_labels(in, partition.second_layer, partition.second_layer_count);
  for (std::size_t f = 0; f < partition.first_layer.size(); ++f) {
    if (partition.parent[partition.second_layer[f]] != partition.first_layer[f]) {
      in.fail("is damaged (the two layers contradict each other)");
    }
  }
}

/// Whether a second-layer node lies on the border of a patch.
bool on_border(const PatchLayer& second, const PatchLayer& layer, Index node, Index patch) {
  const Index own = layer.vertex_node[second.node_vertex[node]];
  if (own == no_index) return false;
  const auto patches = layer.patches_of(own);
  return std::any_of(patches.begin(), patches.end(), [&](const PatchRow& at) { return at.patch == patch; });
}

void load_graph(IndexFileReader& in, SearchGraph& graph, IndexForm form, const PatchLayer& second,
                const PatchLayer& first) {
  const Index nodes = second.node_count();
  const bool has_arcs = form == IndexForm::graph;
  graph.arc_begin = in.block<std::int64_t>(has_arcs ? static_cast<std::size_t>(nodes) + 1 : 0);
  graph.arc = has_arcs ? in.block<Arc>() : in.block<Arc>(0);
  graph.landmark_distance = in.block<double>(static_cast<std::size_t>(nodes) * SearchGraph::landmark_count);
  require_distances(in, graph.landmark_distance);
  if (std::find(graph.landmark_distance.begin(), graph.landmark_distance.end(), unreachable) !=
      graph.landmark_distance.end()) {
    in.fail("is damaged (a landmark is infinitely far)");
  }
  if (!has_arcs) return;
  if (graph.arc_begin.front() != 0 || graph.arc_begin.back() != static_cast<std::int64_t>(graph.arc.size()) ||
      !std::is_sorted(graph.arc_begin.begin(), graph.arc_begin.end())) {
    in.fail("is damaged (the arcs are not in order)");
  }
  for (Index node = 0; node < nodes; ++node) {
    for (const Arc& arc : graph.arcs(node)) {
      const PatchLayer& layer = arc.leg.in_first_layer() ? first : second;
      if (arc.leg.table() == Leg::Table::transit || arc.target < 0 || arc.target >= nodes ||
          !(arc.length >= 0.0f) || !on_border(second, layer, node, arc.leg.patch()) ||
          !on_border(second, layer, arc.target, arc.leg.patch())) {
        in.fail("is damaged (an arc leads nowhere)");
      }
    }
  }
}

}  // namespace

void write_index(IndexFileWriter& out, const IndexData& data) {
  out.block(std::span<const std::uint64_t>(data.fingerprint.words));
  out.block(std::vector<double>{data.statistics.delta});
  out.block(std::vector<std::uint64_t>{
      data.statistics.seed, static_cast<std::uint64_t>(data.graph.arcs_before_pruning),
      data.form() == IndexForm::graph ? 1U : 0U, static_cast<std::uint64_t>(data.requested_patches[0]),
      static_cast<std::uint64_t>(data.requested_patches[1])});
  out.block(data.partition.first_layer);
  out.block(data.partition.second_layer);
  out.block(data.partition.parent);
  out.block(data.second.table);
  out.block(data.first.table);
  out.block(data.transit_table.entry);
  for (const PatchLayer* layer : {&data.second, &data.first}) {
    out.block(layer->scale);
    out.block(layer->offset);
  }
  out.block(data.transit_table.least);
  out.block(std::vector<TableScale>{data.transit_table.scale});
  out.block(data.graph.arc_begin);
  out.block(data.graph.arc);
  out.block(data.graph.landmark_distance);
}

std::uint64_t end_of_index(const std::filesystem::path& file) {
  constexpr int block_count = 18;  // as write_index() writes
  IndexFileReader in(file);
  for (int i = 0; i < block_count; ++i) in.skip_block();
  return in.end();
}

void note_mapped_bytes(IndexData& data) {
  data.statistics.mapped_bytes = 0;
  for (const Entries* table : {&data.second.table, &data.first.table, &data.transit_table.entry}) {
    data.statistics.mapped_bytes += static_cast<std::int64_t>(table->size() * sizeof((*table)[0]));
  }
}

void GeodesicIndex::save(const std::filesystem::path& file) const {
  SavedIndexBytes bytes(file);
  IndexFileWriter out(bytes);
  write_index(out, *data_);
  bytes.finish();
}

std::shared_ptr<const GeodesicIndex> GeodesicIndex::load(const std::filesystem::path& file,
                                                         std::shared_ptr<const Mesh> mesh,
                                                         TableStorage storage) {
  IndexFileReader in(file);
  auto data = std::make_unique<IndexData>();
  data->mesh = std::move(mesh);
  data->fingerprint = fingerprint_of(*data->mesh);
  const auto words = in.block<std::uint64_t>(2);
  if (!std::equal(words.begin(), words.end(), data->fingerprint.words.begin())) {
    throw IndexFileError(
        "The index file " + file.string() +
        " was built for another mesh or with other gaps bridged, or the mesh was edited since; "
        "build the index again.");
  }
  data->statistics.delta = in.block<double>(1)[0];
  const auto numbers = in.block<std::uint64_t>(5);
  data->statistics.seed = numbers[0];
  data->graph.arcs_before_pruning = static_cast<std::int64_t>(numbers[1]);
  if (numbers[2] > 1) in.fail("is damaged (its form is unknown)");
  const IndexForm form = numbers[2] == 1 ? IndexForm::graph : IndexForm::tables;
  for (std::size_t layer = 0; layer < 2; ++layer) {
    if (numbers[3 + layer] > static_cast<std::uint64_t>(data->mesh->face_count())) {
      in.fail("is damaged (more patches than faces)");
    }
    data->requested_patches[layer] = static_cast<Index>(numbers[3 + layer]);
  }
  load_partition(in, data->partition, data->mesh->face_count());
  data->lay_out(0, {});
  load_table(in, data->second, storage);
  if (form == IndexForm::tables) {
    load_table(in, data->first, storage);
  } else {
    in.block<std::uint16_t>(0);
  }
  Entries transit =
      form == IndexForm::tables ? read_entries(in, storage) : Entries(in.block<std::uint16_t>(0));
  load_units(in, data->second);
  if (form == IndexForm::tables) {
    load_units(in, data->first);
    load_transit_units(in, data->transit_table, data->first, std::move(transit));
    data->access_bounds = make_access_bounds(*data);
  } else {
    in.block<TableScale>(0);
    in.block<float>(0);
    in.block<float>(0);
    in.block<TableScale>(1);
  }
  load_graph(in, data->graph, form, data->second, data->first);
  in.finish();
  data->count();
  if (storage == TableStorage::mapped) note_mapped_bytes(*data);
  return std::make_shared<const GeodesicIndex>(std::move(data));
}

}  // namespace vorogeo
