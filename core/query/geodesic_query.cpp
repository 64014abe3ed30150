// Two-point distances and distance fields from an index.
#include "query/geodesic_query.h"

#include <algorithm>
#include <atomic>
#include <string>

#include "index/index_data.h"
#include "index/patch_neighbours.h"
#include "query/border_field.h"
#include "query/field_sweep.h"
#include "query/near_field.h"
#include "query/route_unfolding.h"
#include "query/router.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

/// A sum of two table entries can be too short by their rounding; this much longer it is an upper bound.
constexpr double bound_slack = 1.001;

}  // namespace

struct GeodesicQuery::State {
  State(std::shared_ptr<const GeodesicIndex> shared_index, int requested_threads)
      : index(std::move(shared_index)),
        data(index->data()),
        threads(resolve_thread_count(requested_threads)),
        near(data),
        borders(data),
        patch_neighbours(data.second),
        router(data),
        sweeps(threads),
        unfolder(data) {}

  Index work_vertex(Index vertex, const char* role) const {
    if (vertex < 0 || vertex >= data.mesh->vertex_count()) {
      throw InvalidInput(std::string(role) + " vertex " + std::to_string(vertex) +
                         " does not exist: the mesh has vertices 0 to " +
                         std::to_string(data.mesh->vertex_count() - 1) + ".");
    }
    return data.work.work_vertex[vertex];
  }
  /// Calls visit(patch, column) for the second-layer patches of a vertex and its place among their members.
  template <class Visit>
  void for_each_patch(Index work, Visit&& visit) const {
    const Index node = data.second.vertex_node[work];
    if (node == no_index) {
      visit(data.home_patch[work], data.home_column[work]);
      return;
    }
    for (const PatchRow& at : data.second.patches_of(node)) visit(at.patch, at.row);
  }
  double near_bound(Index source, Index target);
  double route_length(Index source, Index target);
  void add_starts(Index work, Index wave);
  void sweep_patches(Index first_layer_patch, FieldSweep& sweep, double max_distance,
                     std::vector<double>& field);
  void join_near_field(double max_distance, std::vector<double>& field);
  double distance_nearby(Index source, Index target, double bound);

  std::shared_ptr<const GeodesicIndex> index;
  const IndexData& data;
  int threads;
  NearField near;
  BorderField borders;
  PatchNeighbours patch_neighbours;
  Router router;
  std::vector<FieldSweep> sweeps;
  std::vector<BorderField::Start> starts;
  RouteEnd from;
  RouteEnd to;
  GraphRoute far_route;
  RouteUnfolder unfolder;
  std::vector<Index> pair_patches;
  std::vector<float> source_column;
  std::vector<float> target_column;
};

GeodesicQuery::GeodesicQuery(std::shared_ptr<const GeodesicIndex> index, int threads)
    : state_(std::make_unique<State>(std::move(index), threads)) {}
GeodesicQuery::~GeodesicQuery() = default;
GeodesicQuery::GeodesicQuery(GeodesicQuery&&) noexcept = default;
GeodesicQuery& GeodesicQuery::operator=(GeodesicQuery&&) noexcept = default;

const GeodesicIndex& GeodesicQuery::index() const { return *state_->index; }

/// If a patch of one vertex is or touches one of the other: an upper bound of their distance, over the border
/// vertices that both patches have; otherwise unreachable. Leaves the patches in pair_patches.
double GeodesicQuery::State::near_bound(Index source, Index target) {
  const PatchLayer& second = data.second;
  double bound = unreachable;
  pair_patches.clear();
  auto add = [&](Index patch) {
    if (std::find(pair_patches.begin(), pair_patches.end(), patch) == pair_patches.end())
      pair_patches.push_back(patch);
  };
  for_each_patch(source, [&](Index p, Index source_at) {
    for_each_patch(target, [&](Index q, Index target_at) {
      if (p != q && !patch_neighbours.touch(p, q)) return;
      add(p);
      add(q);
      source_column.resize(second.border_size(p));
      target_column.resize(second.border_size(q));
      second.read_column(p, source_at, source_column.data());
      second.read_column(q, target_at, target_column.data());
      // Both lists of nodes ascend.
      const auto here = second.nodes(p);
      const auto there = second.nodes(q);
      for (std::size_t i = 0, k = 0; i < here.size() && k < there.size();) {
        if (here[i] == there[k]) {
          bound = std::min(bound, static_cast<double>(source_column[i]) + target_column[k]);
        }
        const bool next_here = here[i] <= there[k];
        const bool next_there = there[k] <= here[i];
        i += next_here ? 1 : 0;
        k += next_there ? 1 : 0;
      }
    });
  });
  return bound;
}

/// Length of the shortest route of the tables or the graph, unfolded.
double GeodesicQuery::State::route_length(Index source, Index target) {
  // One end is often that of the last pair.
  if (from.vertex != source) route_end(data, source, from);
  if (to.vertex != target) route_end(data, target, to);
  router.route(from, to, far_route);
  if (far_route.length == unreachable) return unreachable;
  return std::min(far_route.length, unfolder.length(far_route, source, target));
}

/// Exact distance of two vertices by propagation around `patches`. If a path could have left the faces
/// allowed to it, a second run over all faces decides; the first one's result keeps it in a thin corridor.
double GeodesicQuery::State::distance_nearby(Index source, Index target, double bound) {
  Halo& halo = near.halo();
  ExactSolver& solver = near.solver();
  halo.surround(pair_patches);
  ExactLimits limits;
  limits.targets = std::span(&target, 1);
  limits.corridor_target = target;
  limits.distances_only = true;
  limits.max_distance = bound * bound_slack;
  limits.face_allowed = halo.mask();
  solver.run_from_vertices(std::span(&source, 1), limits);
  const double found = solver.distance(target);
  if (found < unreachable && found <= solver.barrier_distance()) return found;
  limits.face_allowed = {};
  limits.max_distance = found * (1.0 + 1e-9);
  solver.run_from_vertices(std::span(&source, 1), limits);
  return solver.distance(target);
}

double GeodesicQuery::distance(Index source, Index target) {
  State& state = *state_;
  const IndexData& data = state.data;
  Index s = state.work_vertex(source, "Source");
  Index t = state.work_vertex(target, "Target");
  if (source == target) return 0.0;
  if (s == no_index || t == no_index || data.mesh->component(source) != data.mesh->component(target)) {
    return unreachable;
  }
  prefetch_end(data, s);
  prefetch_end(data, t);
  // One order for both directions makes the answer symmetric to the last bit.
  if (s > t) std::swap(s, t);
  const double bound = state.near_bound(s, t);
  if (!state.pair_patches.empty()) return state.distance_nearby(s, t, bound);
  return state.route_length(s, t);
}

/// The border nodes of the source's patches, with the distances of the tables.
void GeodesicQuery::State::add_starts(Index work, Index wave) {
  const Index node = data.second.vertex_node[work];
  if (node != no_index) {
    starts.push_back({node, 0.0, wave});
    return;
  }
  const Index patch = data.home_patch[work];
  const auto nodes = data.second.nodes(patch);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double distance = data.second.distance(patch, static_cast<Index>(i), data.home_column[work]);
    if (distance < unreachable) starts.push_back({nodes[i], distance, wave});
  }
}

/// Distances through the borders, in all second-layer patches of a first-layer patch.
void GeodesicQuery::State::sweep_patches(Index first_layer_patch, FieldSweep& sweep, double max_distance,
                                         std::vector<double>& field) {
  borders.fill(first_layer_patch, sweep);
  const NodeRange children = borders.children(first_layer_patch);
  for (Index p = children.begin; p < children.end; ++p) {
    const auto found = sweep.sweep(data.second, borders.border(), p);
    const auto members = data.second.members(p);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Index user = data.work.user_vertex[members[i]];
      // A border node belongs to several patches: the first of them writes it.
      if (user == no_index || data.home_patch[members[i]] != p) continue;
      field[user] = found[i] <= max_distance ? found[i] : unreachable;
    }
  }
}

void GeodesicQuery::State::join_near_field(double max_distance, std::vector<double>& field) {
  // Vertices that the user does not have keep nothing.
  double nowhere = unreachable;
  auto at = [&](Index v) -> double& {
    const Index user = data.work.user_vertex[v];
    return user == no_index ? nowhere : field[user];
  };
  near.for_each_held(at, [&](Index v, double exact) { at(v) = exact <= max_distance ? exact : unreachable; });
}

std::vector<double> GeodesicQuery::distance_field(std::span<const Index> sources, double max_distance) {
  State& state = *state_;
  const IndexData& data = state.data;
  if (sources.empty()) throw InvalidInput("There is no source vertex; name at least one.");
  if (!(max_distance >= 0.0)) {
    throw InvalidInput("The greatest distance is " + std::to_string(max_distance) +
                       "; it must be at least 0.");
  }
  // All checked before anything is marked: a refused call leaves the query as it was.
  for (Index source : sources) state.work_vertex(source, "Source");
  std::vector<double> field(data.mesh->vertex_count(), unreachable);
  std::vector<ExactSource> works;
  state.starts.clear();
  state.near.clear();
  for (Index source : sources) {
    const Index work = state.work_vertex(source, "Source");
    field[source] = 0.0;
    if (work == no_index) continue;
    state.add_starts(work, static_cast<Index>(works.size()));
    works.push_back({SurfacePoint::at_vertex(work)});
    state.for_each_patch(work, [&](Index p, Index) { state.near.add(p); });
  }
  if (works.empty()) return field;

  // The near field and the way to the first-layer borders need nothing of each other; all patches need the
  // latter.
  enum BorderState { waiting, ready, failed };
  std::atomic<int> borders = waiting;
  parallel_for(2 + static_cast<std::size_t>(data.first.patch_count), state.threads, {}, "",
               [&](std::size_t item, int worker) {
                 if (item == 0) {
                   state.near.run(works, max_distance, true);
                   return;
                 }
                 if (item == 1) {
                   try {
                     state.borders.start(state.starts, max_distance);
                     borders = ready;
                   } catch (...) {
                     borders = failed;
                     borders.notify_all();
                     throw;
                   }
                   borders.notify_all();
                   return;
                 }
                 borders.wait(waiting);
                 if (borders == failed) return;
                 state.sweep_patches(static_cast<Index>(item - 2), state.sweeps[worker], max_distance, field);
               });
  state.join_near_field(max_distance, field);
  return field;
}

}  // namespace vorogeo
