// Two-point distances and distance fields from an index.
#include "query/geodesic_query.h"

#include <algorithm>
#include <optional>
#include <string>

#include "exact/exact_solver.h"
#include "index/border_search.h"
#include "index/index_data.h"
#include "index/local_tables.h"
#include "query/field_sweep.h"
#include "query/graph_route.h"
#include "query/route_unfolding.h"
#include "query/table_route.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

/// In the patches of the sources the solver's distance holds, unless a way outside their halo is shorter by
/// more than the unfolding can err: then the distance over the border is below this part of it.
constexpr double shorter_outside = 0.99;

/// A route's length can be too short by what unfolding errs; this much longer it is an upper bound.
constexpr double estimate_slack = 1.02;

/// Growth of the halo for the near field: over a border close to the source, the largest errors would lie in
/// the next patch.
constexpr double near_field_growth = 3.0;

}  // namespace

struct GeodesicQuery::State {
  State(std::shared_ptr<const GeodesicIndex> shared_index, int requested_threads)
      : index(std::move(shared_index)),
        data(index->data()),
        threads(resolve_thread_count(requested_threads)),
        solver(data.geometry),
        halo(*data.work.mesh, data.work.second_layer, data.second.patch_count),
        search(data.second),
        graph_router(data),
        table_router(data),
        sweeps(threads),
        is_near(data.second.patch_count, 0) {}

  Index work_vertex(Index vertex, const char* role) const {
    if (vertex < 0 || vertex >= data.mesh->vertex_count()) {
      throw InvalidInput(std::string(role) + " vertex " + std::to_string(vertex) +
                         " does not exist: the mesh has vertices 0 to " +
                         std::to_string(data.mesh->vertex_count() - 1) + ".");
    }
    return data.work.work_vertex[vertex];
  }
  std::vector<Index> patches_of(Index work) const {
    const Index node = data.second.vertex_node[work];
    if (node == no_index) return {data.home_patch[work]};
    std::vector<Index> patches;
    for (const PatchRow& at : data.second.patches_of(node)) patches.push_back(at.patch);
    return patches;
  }
  std::vector<Index> patches_if_near(Index source, Index target) const;
  GraphRoute route(const RouteEnd& from, const RouteEnd& to);
  double distance_nearby(Index source, Index target, const std::vector<Index>& patches, double estimate);

  std::shared_ptr<const GeodesicIndex> index;
  const IndexData& data;
  int threads;
  ExactSolver solver;
  Halo halo;
  BorderSearch search;
  GraphRouter graph_router;
  TableRouter table_router;
  std::vector<FieldSweep> sweeps;
  std::vector<std::uint8_t> is_near;
};

GeodesicQuery::GeodesicQuery(std::shared_ptr<const GeodesicIndex> index, int threads)
    : state_(std::make_unique<State>(std::move(index), threads)) {}
GeodesicQuery::~GeodesicQuery() = default;
GeodesicQuery::GeodesicQuery(GeodesicQuery&&) noexcept = default;
GeodesicQuery& GeodesicQuery::operator=(GeodesicQuery&&) noexcept = default;

const GeodesicIndex& GeodesicQuery::index() const { return *state_->index; }

/// The patches of both vertices if one of the source's is or touches one of the target's; empty if none does.
std::vector<Index> GeodesicQuery::State::patches_if_near(Index source, Index target) const {
  auto patches = patches_of(source);
  const auto of_target = patches_of(target);
  auto is_target_patch = [&](Index p) {
    return std::find(of_target.begin(), of_target.end(), p) != of_target.end();
  };
  auto touches = [&](Index p) {
    const auto nodes = data.second.nodes(p);
    return std::any_of(nodes.begin(), nodes.end(), [&](Index node) {
      const auto at_node = data.second.patches_of(node);
      return std::any_of(at_node.begin(), at_node.end(),
                         [&](const PatchRow& at) { return is_target_patch(at.patch); });
    });
  };
  if (std::none_of(patches.begin(), patches.end(),
                   [&](Index p) { return is_target_patch(p) || touches(p); })) {
    return {};
  }
  for (Index p : of_target) {
    if (std::find(patches.begin(), patches.end(), p) == patches.end()) patches.push_back(p);
  }
  return patches;
}

GraphRoute GeodesicQuery::State::route(const RouteEnd& from, const RouteEnd& to) {
  if (data.node_table.count == 0) return graph_router.route(from, to);
  GraphRoute best = table_router.route(from, to);
  const bool neighbours = std::find_first_of(from.parents.begin(), from.parents.end(), to.parents.begin(),
                                             to.parents.end()) != from.parents.end();
  if (neighbours) {
    // The way may stay inside a first-layer patch.
    GraphRoute inside = graph_router.route(from, to);
    if (inside.length < best.length) best = std::move(inside);
  }
  return best;
}

/// Exact distance of two vertices by propagation around `patches`. If a path could have left the faces
/// allowed to it, a second run over all faces decides; the first one's result keeps it in a thin corridor.
double GeodesicQuery::State::distance_nearby(Index source, Index target, const std::vector<Index>& patches,
                                             double estimate) {
  halo.surround(patches);
  ExactLimits limits;
  limits.targets = std::span(&target, 1);
  limits.corridor_target = target;
  limits.distances_only = true;
  limits.max_distance = estimate * estimate_slack;
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
  // One order for both directions makes the answer symmetric to the last bit.
  if (s > t) std::swap(s, t);
  const RouteEnd from = route_end(data, s);
  const RouteEnd to = route_end(data, t);
  const GraphRoute route = state.route(from, to);
  const auto near = state.patches_if_near(s, t);
  if (!near.empty()) return state.distance_nearby(s, t, near, route.length);
  if (route.length == unreachable) return unreachable;
  return std::min(route.length, unfolded_length(data, route, s, t));
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
  std::vector<Index> starts;
  std::vector<Index> near;
  // Cleared on every way out, as errors leave a query usable.
  const struct Unmark {
    ~Unmark() {
      for (Index p : patches) is_near[p] = 0;
    }
    std::vector<std::uint8_t>& is_near;
    const std::vector<Index>& patches;
  } unmark{state.is_near, near};
  for (Index source : sources) {
    const Index work = state.work_vertex(source, "Source");
    field[source] = 0.0;
    if (work == no_index) continue;
    starts.push_back(work);
    for (Index p : state.patches_of(work)) {
      if (state.is_near[p]) continue;
      near.push_back(p);
      state.is_near[p] = 1;
    }
  }
  if (starts.empty()) return field;

  // Near field: exact in the patches of the sources, and as far beyond as their halo reaches.
  state.halo.surround(near, near_field_growth);
  std::vector<Index> targets;
  for (Index p : near)
    targets.insert(targets.end(), data.second.members(p).begin(), data.second.members(p).end());
  ExactLimits limits;
  limits.face_allowed = state.halo.mask();
  limits.targets = targets;
  limits.distances_only = true;
  limits.max_distance = max_distance;
  state.solver.run_from_vertices(starts, limits);
  // Up to here no path has left the halo.
  const double certain = std::min(state.solver.settled_distance(), state.solver.barrier_distance());

  state.search.start();
  for (Index face : state.halo.faces()) {
    for (Index v : data.work.mesh->face_vertices(face)) {
      const Index node = data.second.vertex_node[v];
      if (node != no_index) state.search.add(node, state.solver.distance(v));
    }
  }
  state.search.run({}, max_distance);

  parallel_for(data.second.patch_count, state.threads, {}, "", [&](std::size_t patch, int worker) {
    const auto p = static_cast<Index>(patch);
    const auto found = state.sweeps[worker].sweep(data.second, state.search, p);
    const auto members = data.second.members(p);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Index user = data.work.user_vertex[members[i]];
      // A border node belongs to several patches: the first of them writes it.
      if (user == no_index || data.home_patch[members[i]] != p) continue;
      const double exact = state.solver.distance(members[i]);
      double distance = found[i];
      if (exact <= certain) {
        distance = exact;
      } else if (!state.is_near[p] || distance < shorter_outside * exact) {
        distance = std::min(exact, distance);
      } else {
        distance = exact;
      }
      field[user] = distance <= max_distance ? distance : unreachable;
    }
  });
  return field;
}

}  // namespace vorogeo
