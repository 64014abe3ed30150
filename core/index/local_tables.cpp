// Exact runs from the border nodes of all patches.
#include "index/local_tables.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>

#include "index/index_options.h"
#include "index/table_filler.h"
#include "support/checkpoint.h"
#include "support/error.h"
#include "support/parallel.h"
#include "support/per_worker.h"
#include "support/thread_clock.h"
#include "weighted/field_timing.h"
#include "weighted/local_solver.h"

namespace vorogeo {

namespace {

constexpr Index nodes_per_group = 16;

/// From so many groups of nodes, or up to twice as many, the cost of all runs is estimated.
constexpr std::size_t groups_to_estimate = 8;
/// Shorter builds need no warning.
constexpr double least_seconds = 1.0;

/// A merged window deviates by at most this fraction of its edge and its distance, on average by far less:
/// the tables resolve some 3e-4 of an edge.
constexpr double merge_tolerance = 2e-4;

/// Solves from the nodes between the same patches, which share one halo.
class GroupSolver {
 public:
  GroupSolver(const TableSurface& surface, const WorkMesh& work, const PatchLayer& layer,
              std::span<const Index> face_begin)
      : surface_(surface),
        work_(work),
        layer_(layer),
        solver_(surface.geometry),
        halo_(*surface.geometry->mesh, face_begin) {}

  void reset(std::span<const PatchRow> patches) {
    patches_.clear();
    for (const PatchRow& at : patches) patches_.push_back(at.patch);
    halo_.surround(patches_, table_growth);
    vertices_.clear();
    points_.clear();
    place_.clear();
    for (Index p : patches_) {
      for (Index member : layer_.members(p)) {
        const Index vertex = surface_.vertex[member];
        if (vertex == no_index) {
          points_.push_back(surface_.edge_point[TableSurface::edge_point_of(work_, member)]);
          place_.push_back(-static_cast<Index>(points_.size()));
        } else {
          vertices_.push_back(vertex);
          place_.push_back(vertex);
        }
      }
    }
  }

  void solve(Index node) {
    const ExactSource source = source_at(layer_.node_vertex[node]);
    ExactLimits limits;
    limits.face_allowed = halo_.mask();
    limits.targets = vertices_;
    limits.edge_targets = points_;
    // Windows behind the front are kept: dropping them takes 3 to 7 % longer on the few faces of a patch.
    limits.merge_tolerance = merge_tolerance;
    solver_.run(std::span(&source, 1), limits);
  }

  /// Writes the distances from the node that was solved last.
  void put_rows(Index node, const TableFiller& tables) {
    auto place = place_.begin();
    for (const PatchRow& at : layer_.patches_of(node)) {
      const Index members = layer_.member_count(at.patch);
      TableDraft* draft = tables.draft(at.patch);
      if (draft == nullptr) {
        place += members;
        continue;
      }
      for (Index i = 0; i < members; ++i, ++place) {
        const double distance =
            *place >= 0 ? solver_.distance(*place) : solver_.distance(points_[-1 - *place]);
        draft->line(i)[at.row] = static_cast<float>(distance);
      }
    }
  }

 private:
  ExactSource source_at(Index work_vertex) const {
    const Index vertex = surface_.vertex[work_vertex];
    if (vertex != no_index) return {SurfacePoint::at_vertex(vertex)};
    const Mesh& mesh = *surface_.geometry->mesh;
    const EdgePoint point = surface_.edge_point[TableSurface::edge_point_of(work_, work_vertex)];
    const double length = mesh.edge_length(point.edge);
    return {point_on_edge(mesh, point.edge, length > 0.0 ? point.position / length : 0.0)};
  }

  const TableSurface& surface_;
  const WorkMesh& work_;
  const PatchLayer& layer_;
  LocalSolver solver_;
  Halo halo_;
  std::vector<Index> patches_;
  std::vector<Index> vertices_;
  std::vector<EdgePoint> points_;
  /// For each member of the patches, patch by patch: its vertex, or -1 - k for points_[k].
  std::vector<Index> place_;
};

double seconds_of(const std::function<void()>& work) {
  const double begin = thread_seconds();
  work();
  return thread_seconds() - begin;
}

constexpr const char* table_phase = "Computing exact distances inside patches";

/// Seconds of one core that all runs will take, by a few of them. `groups`: as of group_by_patches().
double expected_seconds(const PatchLayer& layer, std::span<const Index> groups, GroupSolver& solver,
                        const Progress& progress) {
  const std::size_t count = groups.size() - 1;
  const std::size_t step = std::max<std::size_t>(1, count / groups_to_estimate);
  double seconds = 0.0;
  Index nodes = 0;
  for (std::size_t group = step / 2; group < count; group += step) {
    progress.report(0.0, table_phase);
    const Index first = groups[group], last = groups[group + 1] - 1;
    seconds += seconds_of([&] {
      solver.reset(layer.patches_of(first));
      solver.solve(first);
    });
    // The first run of a group brings its faces into the caches.
    if (last > first) seconds += (last - first) * seconds_of([&] { solver.solve(last); });
    nodes += last - first + 1;
  }
  return nodes == 0 ? 0.0 : seconds * layer.node_count() / nodes;
}

/// Warns if all runs will take as long as many exact fields of the mesh; returns how many then, otherwise 0.
/// Takes some half a percent of their time.
double warn_of_dear_tables(const TableSurface& surface, double seconds, const Progress& progress) {
  if (seconds < least_seconds) return 0.0;
  const FieldTiming field =
      time_exact_field(surface.geometry, seconds / fields_to_warn, progress, table_phase);
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

double expected_table_seconds(const TableSurface& surface, const WorkMesh& work, const PatchLayer& layer,
                              const Progress& progress) {
  const std::vector<Index> groups = group_by_patches(layer, nodes_per_group);
  const std::vector<Index> face_begin = first_faces(surface.second_layer, layer.patch_count);
  GroupSolver solver(surface, work, layer, face_begin);
  return expected_seconds(layer, groups, solver, progress);
}

std::int64_t local_draft_bytes(const PatchLayer& layer) {
  return greatest_draft_bytes(layer, group_by_patches(layer, nodes_per_group));
}

double fill_local_tables(const TableSurface& surface, const WorkMesh& work, PatchLayer& layer,
                         const TableRoom& room, int threads, const Progress& progress) {
  // Small groups, so that progress is steady and all threads have work even when there are few patches.
  const std::vector<Index> groups = group_by_patches(layer, nodes_per_group);
  const std::vector<Index> face_begin = first_faces(surface.second_layer, layer.patch_count);
  const Progress before = progress.part(0.005, 0.01);
  TableFiller tables(layer, room, groups, TableFiller::Closure::closed, threads, progress.part(0.0, 0.005));
  PerWorker<GroupSolver> solvers(threads);
  double fields = 0.0;
  if (!tables.left().empty()) {
    const double seconds =
        expected_seconds(layer, groups, solvers.of(0, surface, work, layer, face_begin), before);
    fields = warn_of_dear_tables(surface, seconds, before);
  }
  const double done =
      1.0 - static_cast<double>(tables.left().size()) / std::max<std::size_t>(1, groups.size() - 1);
  parallel_for(tables.left().size(), threads, progress.part(std::max(done, 0.01), 1.0), table_phase,
               [&](std::size_t item, int worker) {
                 const Index group = tables.left()[item];
                 GroupSolver& solver = solvers.of(worker, surface, work, layer, face_begin);
                 solver.reset(layer.patches_of(groups[group]));
                 tables.begin(group);
                 for (Index node = groups[group]; node < groups[group + 1]; ++node) {
                   checkpoint();
                   solver.solve(node);
                   solver.put_rows(node, tables);
                 }
                 tables.finish(group);
               });
  tables.hand_over();
  return fields;
}

}  // namespace vorogeo
