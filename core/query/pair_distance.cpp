// Ends that are close or in touching patches are solved exactly, all others are routed.
#include "query/pair_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vorogeo {

namespace {

/// A sum of two table entries can be too short by their rounding; multiplied by this it nearly always is an
/// upper bound. A run within less is much narrower: a tenth fewer windows than at 1.001.
constexpr double bound_slack = 1.0003;
/// Where nothing was found within that, and in a metric: where it jumps, propagated distances have errors of
/// their own.
constexpr double wide_bound_slack = 1.01;

/// Bounds by tables where the metric jumps: their entries have errors as those of points on edges.
constexpr double rest_slack = 0.99;

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
  share_patch_ = false;
  patches_.clear();
  auto add = [&](Index patch) {
    if (std::ranges::find(patches_, patch) == patches_.end()) patches_.push_back(patch);
  };
  for_each_patch(data_, source, [&](Index p, Index source_at) {
    for_each_patch(data_, target, [&](Index q, Index target_at) {
      if (p != q && !second.touching.touch(p, q)) return;
      share_patch_ |= p == q;
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

/// Lower bounds of the distances of all members of patches_ from the target, by the triangle inequality over
/// the border nodes whose distance from the target is in a table. `vertex_of_run`: the vertex of the run's
/// mesh that a work vertex is, or no_index; empty if it runs on the work mesh.
void PairDistance::bound_rest(Index target, std::span<const Index> vertex_of_run) {
  const PatchLayer& second = data_.second;
  for (const Index patch : patches_) {
    from_target_.assign(second.border_size(patch), std::numeric_limits<float>::quiet_NaN());
    const TableScale scale = second.scale[patch];
    float step = scale.widest_step(PatchLayer::greatest_entry);
    for_each_patch(data_, target, [&](Index p, Index target_at) {
      step = std::max(step, second.scale[p].widest_step(PatchLayer::greatest_entry));
      const auto nodes = second.nodes(patch);
      for (std::size_t row = 0; row < nodes.size(); ++row) {
        const Index other = second.row_of(nodes[row], p);
        if (other != no_index) from_target_[row] = second.distance(p, other, target_at);
      }
    });
    const auto members = second.members(patch);
    for (Index begin = 0; begin < static_cast<Index>(members.size()); begin += PatchLayer::tile_width) {
      greatest_.assign(PatchLayer::tile_width, 0.0f);
      const std::uint16_t* entries = second.tile(patch, begin / PatchLayer::tile_width);
      for (const float from_target : from_target_) {
        if (from_target < std::numeric_limits<float>::infinity()) {
          for (Index k = 0; k < PatchLayer::tile_width; ++k) {
            const float apart = std::abs(scale.distance(entries[k]) - from_target);
            greatest_[k] = std::max(greatest_[k], apart);
          }
        }
        entries += PatchLayer::tile_width;
      }
      const Index count = std::min(PatchLayer::tile_width, static_cast<Index>(members.size()) - begin);
      for (Index k = 0; k < count; ++k) {
        // Far members have an offset, infinite entries no distance.
        const bool is_far = second.offset_of(patch, begin + k) > 0.0f || second.complete[patch] == 0;
        const Index vertex = vertex_of_run.empty() ? members[begin + k] : vertex_of_run[members[begin + k]];
        if (is_far || vertex == no_index) continue;
        least_rest_[vertex] = rest_slack * std::max(0.0f, greatest_[k] - 2.0f * step);
        bounded_.push_back(vertex);
      }
    }
  }
}

/// Exact distance by propagation. What it may enter is limited by the bound and the straight line to the
/// target, which keep it between the ends; where a metric leaves little of that line, by the patches.
double PairDistance::distance_nearby(Index source, Index target, double bound) {
  // Added points are no vertices of the user's.
  const auto& user = data_.work.user_vertex;
  const bool are_users = user[source] != no_index && user[target] != no_index;
  const UnsplitSurface* unsplit = are_users ? data_.unsplit() : nullptr;
  if (unsplit != nullptr && !solver_) solver_.emplace(unsplit->geometry);
  LocalSolver& solver = unsplit != nullptr ? *solver_ : near_.solver();
  if (solver.mesh().has_metric()) return distance_around_patches(source, target, bound, unsplit);
  if (unsplit != nullptr) {
    source = user[source];
    target = user[target];
  }
  ExactLimits limits;
  limits.targets = std::span(&target, 1);
  limits.corridor_target = target;
  for (const double limit : {bound * bound_slack, bound * wide_bound_slack, unreachable}) {
    limits.max_distance = limit;
    solver.run_from_vertices(std::span(&source, 1), limits);
    // Every path within the limit was followed.
    if (const double found = solver.distance(target); found < unreachable) return found;
  }
  return unreachable;
}

/// The same inside patches_ and their halo. If a path could have left these, a second run over all faces
/// decides, which the result of the first one keeps in a thin corridor. `unsplit`: the surface of the runs,
/// if not the work mesh.
double PairDistance::distance_around_patches(Index source, Index target, double bound,
                                             const UnsplitSurface* unsplit) {
  const auto& user = data_.work.user_vertex;
  const Index target_at = target;
  if (unsplit != nullptr) {
    if (!halo_) halo_.emplace(*data_.mesh, unsplit->first_face, unsplit->faces);
    source = user[source];
    target = user[target];
  }
  Halo& halo = unsplit != nullptr ? *halo_ : near_.halo();
  LocalSolver& solver = unsplit != nullptr ? *solver_ : near_.solver();
  halo.surround(patches_);
  ExactLimits limits;
  limits.targets = std::span(&target, 1);
  limits.corridor_target = target;
  limits.distances_only = true;
  limits.max_distance = bound * wide_bound_slack;
  limits.face_allowed = halo.mask();
  if (solver.mesh().metric_jumps()) {
    for (const Index vertex : bounded_) least_rest_[vertex] = 0.0;
    bounded_.clear();
    least_rest_.resize(solver.mesh().vertex_count(), 0.0);
    bound_rest(target_at, unsplit != nullptr ? std::span<const Index>(user) : std::span<const Index>());
    limits.least_remaining = least_rest_;
  }
  solver.run_from_vertices(std::span(&source, 1), limits);
  const double found = solver.distance(target);
  if (found < unreachable && found <= solver.barrier_distance()) return found;
  limits.face_allowed = {};
  limits.max_distance = found * (1.0 + 1e-9);
  solver.run_from_vertices(std::span(&source, 1), limits);
  const double everywhere = solver.distance(target);
  return everywhere < unreachable ? everywhere : found;
}

/// Whether near ends are solved by propagation. Over points on edges it takes many times as long as by
/// windows, so ends in different patches are routed there, unless they are close.
bool PairDistance::is_solved(double bound) const {
  if (patches_.empty()) return false;
  return share_patch_ || !data_.work.mesh->metric_jumps() || is_close(bound);
}

/// Whether a length is no more than what a near field solves around its source.
bool PairDistance::is_close(double length) const {
  const double members = static_cast<double>(data_.work.mesh->vertex_count()) / data_.second.patch_count;
  return length <= NearField::reach * std::sqrt(members) * data_.work.mesh->typical_edge_length();
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
  if (is_solved(bound)) return distance_nearby(source, target, bound);
  const double routed = route_length(source, target);
  // Beyond a patch as narrow as this, crossings are so close to both ends that they are off by most.
  if (is_close(routed) && !data_.work.mesh->has_metric()) return distance_nearby(source, target, routed);
  return routed;
}

}  // namespace vorogeo
