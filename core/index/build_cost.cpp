// Sizes of both forms from the layout, and times of some of the work that a build does.
#include "index/build_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "exact/local_solver.h"
#include "index/border_pieces.h"
#include "index/local_tables.h"
#include "mesh/outliers.h"
#include "patches/partition.h"
#include "support/error.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

void require_buildable(const Mesh& mesh, const IndexOptions& options) {
  require_both_ways_alike(mesh, "Indexes");
  if (!(options.delta >= 0.0 && options.delta < 1.0)) {
    throw InvalidInput("delta is " + std::to_string(options.delta) +
                       "; it must be at least 0 (nothing lost) and below 1.");
  }
  if (options.memory_budget < 0) {
    throw InvalidInput("The memory budget is " + std::to_string(options.memory_budget) +
                       " MiB; give a positive number, or 0 for " + std::to_string(default_memory_budget) +
                       " MiB.");
  }
  require_lengths(mesh, "an index takes", index_lengths);
}

// ---- Memory, and the form that it allows

namespace {

constexpr std::int64_t bytes_per_mib = 1 << 20;

}  // namespace

std::int64_t table_bytes(const PatchLayer& layer) {
  return static_cast<std::int64_t>(layer.table_begin.back() * sizeof(layer.table[0]) +
                                   layer.patch_count * (sizeof(layer.scale[0]) + sizeof(layer.complete[0])));
}

std::int64_t MemoryBudget::mib() const {
  if (options_.memory_budget != 0) return options_.memory_budget;
  return tables_in_file_ ? std::numeric_limits<std::int64_t>::max() : default_memory_budget;
}

bool MemoryBudget::fits(std::int64_t bytes) const {
  return (bytes + bytes_per_mib - 1) / bytes_per_mib <= mib();
}

void MemoryBudget::refuse(std::int64_t bytes, const char* comparison) const {
  const bool is_pruned = options_.delta > 0.0;
  throw InvalidInput(
      "The memory budget is " + std::to_string(mib()) + " MiB, but the index of this mesh takes " +
      comparison + " " + std::to_string((bytes + bytes_per_mib - 1) / bytes_per_mib) +
      " MiB in its smallest form: give a larger memory budget" +
      (is_pruned ? " or a larger delta." : ", or a delta above 0, which makes the graph smaller."));
}

std::int64_t MemoryBudget::layer_bytes(const IndexData& data) const {
  return tables_in_file_ ? 0 : table_bytes(data.second) + table_bytes(data.first);
}

IndexForm MemoryBudget::form_of(std::int64_t with_transit) const {
  return options_.delta == 0.0 && fits(with_transit) ? IndexForm::tables : IndexForm::graph;
}

IndexForm MemoryBudget::form_of(const IndexData& data) const {
  const std::int64_t landmarks = static_cast<std::int64_t>(sizeof(Landmarks::Row)) * data.second.node_count();
  const std::int64_t both = data.bytes() + layer_bytes(data) + landmarks;
  const std::int64_t tables = both + transit_bytes(data.first, tables_in_file_) + access_bounds_bytes(data);
  const IndexForm form = form_of(tables);
  if (form == IndexForm::graph && !fits(both)) refuse(both, "more than");
  return form;
}

void MemoryBudget::require(const IndexData& data) const {
  const std::int64_t in_file = tables_in_file_ ? table_bytes(data.second) + table_bytes(data.first) : 0;
  if (!fits(data.bytes() - in_file)) refuse(data.bytes() - in_file, "at least");
}

// ---- Time: parts of the mesh are laid out, and some runs are timed

namespace {

constexpr const char* estimate_phase = "Estimating what an index costs";

/// Larger meshes are judged by parts with about this many faces together.
constexpr Index max_faces = 60000;
/// Parts of a large mesh, whose first faces are evenly spaced by number.
constexpr int parts = 2;
/// An exact field is timed for so long, and then extrapolated.
constexpr double max_field_seconds = 0.5;

// Seconds of one core for what is not timed, measured on scans and parts (docs/figures.md).
constexpr double seconds_per_first_byte = 2.5e-7;
constexpr double seconds_per_transit_byte = 1.25e-7;
/// Per byte and node on the border of a first-layer patch: searches that fill the table scan borders.
constexpr double seconds_per_transit_byte_and_node = 1.75e-10;
/// Of an entry of any table.
constexpr double bytes_per_entry = sizeof(std::uint16_t);
/// At least this share of the borders is taken to be inside parts of a mesh, however few patches they have.
constexpr double least_inside = 0.5;
/// A field from the index: its exact run around the source takes this many times as long as a run from a
/// border vertex; then it reads all tables.
constexpr double runs_near_source = 1.6;
/// The exact part by points on edges, where the metric jumps.
constexpr double seconds_near_source_of_jumps = 1.5e-2;
constexpr double seconds_per_vertex = 1.2e-7;

/// Faces around a few evenly spaced ones, as a mesh of its own.
std::shared_ptr<const Mesh> part_of(const Mesh& mesh) {
  std::vector<std::uint8_t> taken(mesh.face_count(), 0);
  std::vector<Index> faces;
  for (int part = 0; part < parts; ++part) {
    const auto wanted = static_cast<std::size_t>(max_faces / parts * (part + 1));
    // From component to component until there are enough.
    for (Index first = mesh.face_count() / parts * part; first < mesh.face_count(); ++first) {
      if (faces.size() >= wanted) break;
      if (taken[first] != 0) continue;
      std::size_t at = faces.size();
      taken[first] = 1;
      faces.push_back(first);
      for (; at < faces.size() && faces.size() < wanted; ++at) {
        for (Index h = 3 * faces[at]; h < 3 * faces[at] + 3; ++h) {
          for (Index g = mesh.next_around_edge(h); g != h; g = mesh.next_around_edge(g)) {
            // What lies behind a face already taken is left to that face.
            if (taken[Mesh::face_of(g)] != 0 || faces.size() >= wanted) break;
            taken[Mesh::face_of(g)] = 1;
            faces.push_back(Mesh::face_of(g));
          }
        }
      }
    }
  }
  std::vector<Index> renamed(mesh.vertex_count(), no_index);
  std::vector<Point> positions;
  std::vector<std::array<Index, 3>> corners;
  SideLengths sides;
  for (Index f : faces) {
    corners.push_back(mesh.face_vertices(f));
    if (mesh.has_metric()) sides.push_back(mesh.side_lengths(f));
    for (Index& v : corners.back()) {
      if (renamed[v] == no_index) {
        renamed[v] = static_cast<Index>(positions.size());
        positions.push_back(mesh.position(v));
      }
      v = renamed[v];
    }
  }
  return mesh_in_metric_of(mesh, std::move(positions), corners, std::move(sides));
}

/// The numbers of patches asked for, scaled for a part of a mesh with `scale` times its faces and so many
/// first-layer patches: as dense as on the whole.
PartitionOptions share_of(const PartitionOptions& asked, double first_patches, const Mesh& part,
                          double scale) {
  PartitionOptions share = asked;
  if (scale == 1.0) return share;
  auto at_least_one = [](double patches) { return static_cast<Index>(std::max(1L, std::lround(patches))); };
  if (asked.first_layer_patches > 0) share.first_layer_patches = at_least_one(first_patches / scale);
  if (asked.second_layer_patches > 0) {
    const double own_first = planned_first_layer(part, part.vertex_count(), share);
    share.second_layer_patches = at_least_one(asked.second_layer_patches * first_patches / scale / own_first);
  }
  return share;
}

}  // namespace

BuildEstimate estimate_build(const std::shared_ptr<const Mesh>& mesh, const IndexOptions& options,
                             const Progress& progress) {
  require_buildable(*mesh, options);
  const Watch watch(progress, estimate_phase);
  const Progress still = progress.part(0.0, 0.0);
  IndexData data;
  data.mesh = mesh->face_count() > max_faces ? part_of(*mesh) : mesh;
  const double scale = static_cast<double>(mesh->face_count()) / std::max<Index>(1, data.mesh->face_count());
  const double vertices = static_cast<double>(data.mesh->vertex_count()) * scale;
  const PartitionOptions asked{options.first_layer_patches, options.second_layer_patches, options.seed, 1};
  const double first_patches = planned_first_layer(*data.mesh, vertices, asked);
  // Of loops that all cores share this counts one thread's part; they are a small part of the layout.
  const double start = thread_seconds();
  data.partition = partition_for_index(*data.mesh, share_of(asked, first_patches, *data.mesh, scale), still);
  data.lay_out(1, still);
  const double layout_seconds = (thread_seconds() - start) * scale;
  const double run_seconds = expected_table_seconds(data, still) * scale;

  double second_nodes = data.second.node_count() * scale;
  double first_nodes = data.first.node_count();
  double first_layer = data.first.patch_count;
  double border_of_first = 2.0 * first_nodes / std::max(1.0, first_layer);
  double transit = static_cast<double>(transit_bytes(data.first, false));
  double first = static_cast<double>(table_bytes(data.first));
  if (scale > 1.0) {
    // The borders of k round patches on n vertices grow in length with the square roots of both. A part has
    // few first-layer patches; the borders of its second layer tell more. Those along its rim are missing.
    const double second_patches = std::max(1.0, static_cast<double>(data.second.patch_count));
    second_nodes /= std::max(least_inside, 1.0 - std::sqrt(parts / second_patches));
    const double components = components_with_faces(*mesh);
    first_layer = std::max(first_patches, components);
    first_nodes =
        second_nodes * std::sqrt(first_layer / (second_patches * scale)) * (1.0 - components / first_layer);
    border_of_first = 2.0 * first_nodes / first_layer;
    transit = bytes_per_entry * first_nodes * first_nodes;
    // Members are the second-layer nodes; those on its borders belong to two first-layer patches.
    first = bytes_per_entry * border_of_first * (second_nodes + first_nodes);
  }
  const double second = static_cast<double>(table_bytes(data.second)) * scale;
  const double kept = (static_cast<double>(data.bytes()) + static_cast<double>(access_bounds_bytes(data)) +
                       sizeof(Landmarks::Row) * data.second.node_count()) *
                          scale +
                      second + first;

  BuildEstimate estimate;
  const std::int64_t with_tables = static_cast<std::int64_t>(kept + transit);
  estimate.form = MemoryBudget(options).form_of(with_tables);
  estimate.bytes = estimate.form == IndexForm::tables ? with_tables : static_cast<std::int64_t>(kept);
  const int threads = resolve_thread_count(options.threads);
  estimate.core_seconds = layout_seconds + run_seconds + seconds_per_first_byte * first;
  if (estimate.form == IndexForm::tables) {
    estimate.core_seconds +=
        (seconds_per_transit_byte + seconds_per_transit_byte_and_node * border_of_first) * transit;
  }
  estimate.build_seconds = estimate.core_seconds / threads;
  const double run = run_seconds / (scale * std::max<Index>(1, data.second.node_count()));
  estimate.field_seconds = (mesh->metric_jumps() ? seconds_near_source_of_jumps : runs_near_source * run) +
                           seconds_per_vertex * vertices / threads;
  const auto geometry = std::make_shared<const LocalGeometry>(mesh);
  estimate.exact_field_seconds =
      time_exact_field(geometry, max_field_seconds, still, estimate_phase).expected_seconds();
  // Without borders, the near field is all.
  if (data.second.node_count() == 0) estimate.field_seconds = estimate.exact_field_seconds;
  return estimate;
}

}  // namespace vorogeo
