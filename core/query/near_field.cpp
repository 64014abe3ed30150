// The bounded runs of the solver around the sources of a field.
#include "query/near_field.h"

#include <algorithm>
#include <cmath>

namespace vorogeo {

NearField::NearField(const IndexData& data)
    : data_(data),
      solver_(data.geometry),
      halo_(*data.surface.mesh, data.first_face),
      is_near_(data.second.patch_count, 0),
      is_entered_(data.second.patch_count, 0) {}

/// Adds a patch in which distances are to be exact, unless it was added before.
void NearField::add(Index patch) {
  if (is_near_[patch] != 0) return;
  patches_.push_back(patch);
  is_near_[patch] = 1;
}

/// Adds the patches of the faces at a point, and those just behind a border close to it.
void NearField::add_at(const SurfacePoint& point) {
  const Mesh& mesh = *data_.surface.mesh;
  for_each_face_at(mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    add(data_.surface.second_layer[face]);
    const double twice_area = 2.0 * mesh.face_area(face);
    for (int i = 0; i < 3; ++i) {
      const Index own = 3 * face + i;
      const auto [first, last] = data_.surface.places_inside(mesh.edge_of(own));
      const double length = mesh.side_length(own) / (1.0 + last - first);
      // If the point is on the side, the faces behind it are visited themselves.
      if (!(weights[(i + 2) % 3] > 0.0)) continue;
      if (weights[(i + 2) % 3] * twice_area >= near_border_edge * length * mesh.side_length(own)) continue;
      for (Index h = mesh.next_around_edge(own); h != own; h = mesh.next_around_edge(h)) {
        add(data_.surface.second_layer[Mesh::face_of(h)]);
      }
    }
  });
}

void NearField::solve(std::span<const ExactSource> sources, double max_distance,
                      const TangentFrame* directions) {
  ExactLimits limits;
  limits.face_allowed = halo_.mask();
  limits.targets = targets_.vertices;
  limits.edge_targets = targets_.points;
  limits.max_distance = max_distance;
  limits.directions = directions;
  solver_.run(sources, limits);
  certain_ = std::min(solver_.settled_distance(), solver_.barrier_distance());
}

void NearField::run(std::span<const ExactSource> sources, double max_distance,
                    const TangentFrame* directions) {
  for (Index p : patches_) is_near_[p] = 0;
  patches_.clear();
  for (const ExactSource& one : sources) add_at(one.point);
  if (directions != nullptr) {
    const std::vector<Index> own = patches_;
    for (Index p : own) std::ranges::for_each(data_.second.touching[p], [&](Index other) { add(other); });
  }
  targets_.clear();
  Index patch_faces = 0;
  for (Index p : patches_) {
    targets_.add(data_.surface, data_.second.members(p));
    patch_faces += data_.first_face[p + 1] - data_.first_face[p];
  }
  around_.clear();
  double nearest_offset = unreachable;
  for (const ExactSource& one : sources) {
    for_each_face_at(*data_.surface.mesh, one.point,
                     [&](Index face, const std::array<double, 3>&) { around_.push_back(face); });
    nearest_offset = std::min(nearest_offset, one.offset);
  }
  halo_.surround(patches_, directions != nullptr ? growth_with_directions : growth);
  const auto patches = static_cast<double>(std::max<std::size_t>(patches_.size(), 1));
  const double members = static_cast<double>(targets_.size()) / patches;
  halo_.widen(around_, static_cast<int>(std::lround(reach * std::sqrt(members))),
              static_cast<std::size_t>(max_faces * members * static_cast<double>(sources.size())));
  solve(sources, max_distance, directions);
  const double most = most_widened * static_cast<double>(halo_.faces().size());
  double piece = 0.0;
  for (const Index p : patches_) piece = std::max(piece, data_.longest_piece[p]);
  const double least = std::min(max_distance, nearest_offset + piece);
  // Each round doubles the faces or is the last.
  while (static_cast<double>(halo_.faces().size()) <= most && solver_.barrier_distance() < least) {
    const std::size_t before = halo_.faces().size();
    halo_.surround(patches_, 2.0 * static_cast<double>(before) / patch_faces);
    solve(sources, max_distance, directions);
    if (halo_.faces().size() <= before) break;
  }
  for (Index p : entered_) is_entered_[p] = 0;
  entered_.clear();
  for (Index face : halo_.faces()) {
    const Index patch = data_.surface.second_layer[face];
    if (is_entered_[patch] != 0) continue;
    is_entered_[patch] = 1;
    entered_.push_back(patch);
  }
}

}  // namespace vorogeo
