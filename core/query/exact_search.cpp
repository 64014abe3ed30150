// Exact runs from point to point, within whatever bounds are known.
#include "query/exact_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace vorogeo {

// ---- The path of one run of the exact solver

void FoundPath::join(FoundPath other) {
  if (other.path.length < path.length) {
    path = std::move(other.path);
    on_user_mesh = other.on_user_mesh;
  }
  distance = std::min(distance, other.distance);
}

FoundPath FoundPath::unproven() && {
  distance = unreachable;
  return std::move(*this);
}

MeasuredLength set_ends(const Mesh& mesh, const SurfacePoint& first, const SurfacePoint& last,
                        SurfacePath& path) {
  if (path.points.empty()) return {};
  if (is_same_point(mesh, path.points.front(), first)) path.points.front() = first;
  if (path.points.size() == 1) path.points.push_back(last);
  if (is_same_point(mesh, path.points.back(), last)) path.points.back() = last;
  const MeasuredLength measured = measured_length(mesh, path.points);
  // Where they agree, the sum of the steps in the plane has less rounding.
  if (!measured.agrees_with(path.length)) path.length = measured.length;
  return measured;
}

FoundPath CorridorSearch::run(const SurfacePoint& from, const SurfacePoint& to, ExactLimits limits) {
  const ExactSource source{from};
  if (limits.max_distance < unreachable) {
    limits.max_distance *= 1.0 + path_tolerance;
    limits.corridor_point = &to;
  }
  if (solver_.mesh().metric_jumps()) {
    // There bounds are too weak to end a run: what comes after the target is not needed.
    limits.corridor_point = &to;
    limits.targets = to.is_vertex() ? std::span(&to.vertex, 1)
                                    : std::span<const Index>(solver_.mesh().face_vertices(to.face));
  }
  solver_.run(std::span(&source, 1), limits);
  FoundPath found{solver_.path_to_source(to), solver_.distance(to)};
  if (found.path.points.empty()) found.path.length = unreachable;
  std::ranges::reverse(found.path.points);
  return found;
}

FoundPath CorridorSearch::within(const SurfacePoint& from, const SurfacePoint& to, double max_distance,
                                 std::span<const std::uint8_t> face_allowed) {
  ExactLimits limits;
  limits.max_distance = max_distance;
  limits.face_allowed = face_allowed;
  FoundPath found = run(from, to, limits);
  // A path outside may be shorter.
  if (!face_allowed.empty() && found.distance > solver_.barrier_distance()) found.distance = unreachable;
  return found;
}

// ---- Searches and sweeps in the patches of a corridor

RemainingBounds::RemainingBounds(const IndexData& data)
    : data_(data),
      borders_(data),
      bound_(data.work.mesh->vertex_count(), unreachable),
      allowed_(data.second.patch_count, 0),
      is_near_(data.second.patch_count, 0) {}

void RemainingBounds::allow_patches(const RouteEnd& source, const RouteEnd& target, double length) {
  constexpr int count = SearchGraph::landmark_count;
  std::array<std::array<double, count>, 2> at_end{};
  const RouteEnd* ends[2] = {&source, &target};
  for (int side : {0, 1}) {
    at_end[side].fill(unreachable);
    for (const auto& seed : ends[side]->seeds) {
      const double* landmark = data_.graph.landmarks(seed.node);
      for (int l = 0; l < count; ++l)
        at_end[side][l] = std::min(at_end[side][l], landmark[l] + seed.distance);
    }
  }
  const double max_length = length * (1.0 + 2.0 * index_margin);
  for (Index p = 0; p < data_.second.patch_count; ++p) {
    allowed_[p] = 0;
    for (const Index node : data_.second.nodes(p)) {
      const double* landmark = data_.graph.landmarks(node);
      double bound[2] = {0.0, 0.0};
      for (int side : {0, 1}) {
        for (int l = 0; l < count; ++l)
          bound[side] = std::max(bound[side], std::abs(landmark[l] - at_end[side][l]));
      }
      if (bound[0] + bound[1] <= max_length) {
        allowed_[p] = 1;
        break;
      }
    }
  }
}

std::span<const double> RemainingBounds::fill(const RouteEnd& source, const RouteEnd& target,
                                              std::span<const Index> target_patches, double length) {
  const PatchLayer& second = data_.second;
  for (Index p : swept_) {
    for (Index v : second.members(p)) bound_[v] = unreachable;
  }
  swept_.clear();
  allow_patches(source, target, length);
  seeds_.clear();
  for (const auto& seed : target.seeds) seeds_.push_back({seed.node, seed.distance, 0});
  borders_.reset(seeds_, length * (1.0 + index_margin));

  // The patches around the target, and those that touch them.
  std::vector<Index> near(target_patches.begin(), target_patches.end());
  for (Index p : target_patches) {
    const auto touching = second.touching.of(p);
    near.insert(near.end(), touching.begin(), touching.end());
  }
  for (Index p : near) is_near_[p] = 1;
  const double margin = index_margin_in_edges * data_.work.mesh->typical_edge_length();
  for (Index parent = 0; parent < data_.first.patch_count; ++parent) {
    bool is_filled = false;
    for (Index p : data_.children(parent)) {
      if (!allowed_[p] && !is_near_[p]) continue;
      const auto members = second.members(p);
      if (is_near_[p]) {
        swept_.push_back(p);
        for (Index v : members) bound_[v] = 0.0;
        continue;
      }
      if (!is_filled) borders_.fill(parent, sweep_);
      is_filled = true;
      const auto distance = borders_.border().distance;
      if (std::ranges::none_of(second.nodes(p), [&](Index node) { return distance[node] <= length; }))
        continue;
      swept_.push_back(p);
      const auto found = sweep_.sweep(second, borders_.border(), p);
      for (std::size_t i = 0; i < members.size(); ++i) {
        const double least = std::max(0.0, found[i] * (1.0 - index_margin) - margin);
        bound_[members[i]] = std::min(bound_[members[i]], least);
      }
    }
  }
  for (Index p : near) is_near_[p] = 0;
  return bound_;
}

// ---- Searches from nearby to everywhere, each within what is known by then

ExactSearch::ExactSearch(const IndexData& data)
    : data_(data),
      unsplit_(data.unsplit()),
      corridor_(unsplit_ != nullptr ? unsplit_->geometry : data.geometry),
      halo_(unsplit_ != nullptr ? Halo(*data.mesh, unsplit_->first_face, unsplit_->faces)
                                : Halo(*data.work.mesh, data.first_face)),
      bounds_(data) {}

FoundPath ExactSearch::run(const PathEnd& from, const PathEnd& to, const ExactLimits& limits) {
  const bool on_user_mesh = unsplit_ != nullptr;
  FoundPath found =
      on_user_mesh ? corridor_.run(from.user, to.user, limits) : corridor_.run(from.point, to.point, limits);
  found.on_user_mesh = on_user_mesh;
  return found;
}

FoundPath ExactSearch::within(const PathEnd& from, const PathEnd& to, double max_distance,
                              std::span<const std::uint8_t> face_allowed) {
  if (unsplit_ == nullptr || face_allowed.empty()) return within_mask(from, to, max_distance, face_allowed);
  user_mask_.assign(data_.mesh->face_count(), 0);
  for (std::size_t f = 0; f < face_allowed.size(); ++f) {
    if (face_allowed[f] != 0) user_mask_[data_.work.user_face[f]] = 1;
  }
  return within_mask(from, to, max_distance, user_mask_);
}

FoundPath ExactSearch::within_mask(const PathEnd& from, const PathEnd& to, double max_distance,
                                   std::span<const std::uint8_t> mask) {
  const bool on_user_mesh = unsplit_ != nullptr;
  FoundPath found = on_user_mesh ? corridor_.within(from.user, to.user, max_distance, mask)
                                 : corridor_.within(from.point, to.point, max_distance, mask);
  found.on_user_mesh = on_user_mesh;
  return found;
}

FoundPath ExactSearch::between_landmarks(const PathEnd& from, const PathEnd& to, double max_distance) {
  ExactLimits limits;
  limits.max_distance = max_distance;
  limits.landmarks = landmarks_.get();
  return run(from, to, limits);
}

FoundPath ExactSearch::by_index(const PathEnd& from, const PathEnd& to, double max_distance) {
  ExactLimits limits;
  limits.max_distance = max_distance;
  limits.least_remaining =
      bounds_.fill(route_end_of(data_, from), route_end_of(data_, to), to.patches, max_distance);
  if (unsplit_ != nullptr) {
    user_bound_.assign(data_.mesh->vertex_count(), unreachable);
    for (std::size_t v = 0; v < user_bound_.size(); ++v) {
      const Index work = data_.work.work_vertex[v];
      if (work != no_index) user_bound_[v] = limits.least_remaining[work];
    }
    limits.least_remaining = user_bound_;
  }
  return run(from, to, limits).unproven();
}

FoundPath ExactSearch::nearby(const PathEnd& from, const PathEnd& to, double estimate) {
  std::vector<Index> patches = from.patches;
  for (Index p : to.patches) {
    if (std::ranges::find(patches, p) == patches.end()) patches.push_back(p);
  }
  halo_.surround(patches);
  FoundPath found = within_mask(from, to, estimate, halo_.mask());
  if (found.distance == unreachable) {
    found.join(within_mask(from, to, std::min(found.path.length, estimate), {}));
  }
  return found;
}

FoundPath ExactSearch::everywhere(const PathEnd& from, const PathEnd& to) { return run(from, to, {}); }

}  // namespace vorogeo
