// Ends in touching patches are solved exactly, all others are routed.
#include "field/pair_distance.h"

#include <algorithm>

namespace vorogeo {

namespace {

/// A sum of two table entries can be too short by their rounding; multiplied by this it is an upper bound.
constexpr double bound_slack = 1.001;

/// Calls visit(patch, column) for the second-layer patches of a vertex and its place among their members.
template <class Visit>
void for_each_patch(const IndexData& data, Index vertex, Visit&& visit) {
  const Index node = data.second.vertex_node[vertex];
  if (node == no_index) {
    visit(data.home_patch[vertex], data.home_column[vertex]);
    return;
  }
  for (const PatchRow& at : data.second.patches_of(node)) visit(at.patch, at.row);
}

}  // namespace

PairDistance::PairDistance(const IndexData& data, NearField& near)
    : data_(data), near_(near), router_(data), unfolder_(data) {}

/// If a patch of one vertex is or touches one of the other: an upper bound of their distance, over the border
/// vertices that both patches share; otherwise unreachable. Leaves the patches in patches_.
double PairDistance::bound_by_tables(Index source, Index target) {
  const PatchLayer& second = data_.second;
  double bound = unreachable;
  patches_.clear();
  auto add = [&](Index patch) {
    if (std::ranges::find(patches_, patch) == patches_.end()) patches_.push_back(patch);
  };
  for_each_patch(data_, source, [&](Index p, Index source_at) {
    for_each_patch(data_, target, [&](Index q, Index target_at) {
      if (p != q && !second.touching.touch(p, q)) return;
      add(p);
      add(q);
      source_column_.resize(second.border_size(p));
      target_column_.resize(second.border_size(q));
      second.read_column(p, source_at, source_column_.data());
      second.read_column(q, target_at, target_column_.data());
      // Both lists of nodes are ascending.
      const auto here = second.nodes(p);
      const auto there = second.nodes(q);
      for (std::size_t i = 0, k = 0; i < here.size() && k < there.size();) {
        if (here[i] == there[k]) {
          bound = std::min(bound, static_cast<double>(source_column_[i]) + target_column_[k]);
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

/// Exact distance by propagation around patches_. If a path could have left the allowed faces, a second run
/// over all faces decides, which the result of the first one keeps in a thin corridor.
double PairDistance::distance_nearby(Index source, Index target, double bound) {
  // Added points are no vertices of the user's.
  const auto& user = data_.work.user_vertex;
  const bool are_users = user[source] != no_index && user[target] != no_index;
  const UnsplitSurface* unsplit = are_users ? data_.unsplit() : nullptr;
  if (unsplit != nullptr) {
    if (!solver_) solver_.emplace(unsplit->geometry);
    if (!halo_) halo_.emplace(*data_.mesh, unsplit->first_face, unsplit->faces);
    source = user[source];
    target = user[target];
  }
  Halo& halo = unsplit != nullptr ? *halo_ : near_.halo();
  ExactSolver& solver = unsplit != nullptr ? *solver_ : near_.solver();
  halo.surround(patches_);
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

/// Length of the shortest route of the tables or the graph, unfolded.
double PairDistance::route_length(Index source, Index target) {
  // One end is often the same as in the last pair.
  if (from_.vertex != source) route_end(data_, source, from_);
  if (to_.vertex != target) route_end(data_, target, to_);
  router_.route(from_, to_, route_);
  if (route_.length == unreachable) return unreachable;
  return std::min(route_.length, unfolder_.length(route_, source, target));
}

double PairDistance::distance(Index a, Index b) {
  prefetch_end(data_, a);
  prefetch_end(data_, b);
  const auto [source, target] = std::minmax(a, b);
  const double bound = bound_by_tables(source, target);
  if (!patches_.empty()) return distance_nearby(source, target, bound);
  return route_length(source, target);
}

}  // namespace vorogeo
