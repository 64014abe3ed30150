// The points that are seen from a side of a face: those of its other two sides.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <utility>

#include "exact/refraction.h"
#include "mesh/mesh.h"
#include "support/types.h"

namespace vorogeo {

/// A point of another side of a face that is crossed.
struct PointAcross {
  Index point;
  FaceNorms::Place place;
  FaceNorms::Place direction;  ///< of its side
  double dearer;               ///< see RayAtEdge
  double shift;                ///< likewise
  double drift;                ///< from the first vertex of the side that is crossed
};

/// A face crossed from one of its sides: the points of the other two sides, numbered from the first vertex of
/// the side to the apex and on to its second vertex, in the order in which rays that do not cross meet them.
template <bool one_way>
class PointsAcross {
 public:
  struct Side {
    Index first_point = no_index;
    std::span<const float> fractions;
    Index pieces = 0;
    bool from_apex = false;
    double x = 0.0;                ///< of its vertex on the side that is crossed
    FaceNorms::Place step{};       ///< from there to the apex
    FaceNorms::Place direction{};  ///< along its edge, of length 1
    double dearer = 1.0;
    double shift = 0.0;
    double drift = 0.0;       ///< to its vertex on the side that is crossed
    double drift_step = 0.0;  ///< from there to the apex

    /// A place on this side as a number between those of its points, counted from the side that is crossed.
    double number_at(double part) const {
      const double at = from_apex ? 1.0 - part : part;
      const auto next = std::ranges::upper_bound(fractions, at);
      const double before = next == fractions.begin() ? 0.0 : *(next - 1);
      const double behind = next == fractions.end() ? 1.0 : *next;
      const double number = static_cast<double>(next - fractions.begin()) + (at - before) / (behind - before);
      return from_apex ? pieces - number : number;
    }
  };

  PointsAcross(const FaceNorms& norms, Index halfedge, const EdgeFrame& frame)
      : apex_{frame.apex_x, frame.apex_y},
        apex_drift_(frame.apex_drift),
        apex_point_(norms.mesh().apex(halfedge)) {
    const Mesh& mesh = norms.mesh();
    const Index next = Mesh::next_in_face(halfedge);
    const Index previous = Mesh::previous_in_face(halfedge);
    const std::array<Index, 2> sides{frame.along ? previous : next, frame.along ? next : previous};
    for (int i = 0; i < 2; ++i) {
      Side& side = side_[i];
      const Index edge = mesh.edge_of(sides[i]);
      const double length = mesh.side_length(sides[i]);
      const double scale = length > 0.0 ? 1.0 / length : 0.0;
      const double cost = norms.edge_cost(edge);
      side.fractions = norms.fractions_of(edge);
      side.pieces = norms.points_on(edge) + 1;
      if (side.pieces > 1) side.first_point = norms.point(edge, 1);
      side.from_apex = mesh.edge_vertices(edge)[0] == apex_point_;
      side.x = i == 0 ? 0.0 : frame.length;
      side.step = {frame.apex_x - side.x, frame.apex_y};
      side.direction = {side.step[0] * scale, side.step[1] * scale};
      if (side.from_apex) side.direction = {-side.direction[0], -side.direction[1]};
      side.dearer = cost > 0.0 ? length / cost : 1.0;
      if constexpr (!one_way) continue;
      side.shift = norms.shift(sides[i]);
      side.drift = i == 0 ? 0.0 : frame.drift;
      side.drift_step = frame.apex_drift - side.drift;
    }
  }

  Index count() const { return side_[0].pieces + side_[1].pieces - 1; }
  /// The point with a number from 1 to count().
  PointAcross at(Index number) const {
    const Index before = side_[0].pieces;
    if (number == before) return {apex_point_, apex_, {1.0, 0.0}, 1.0, 0.0, apex_drift_};
    const Side& side = side_[number > before];
    const Index k = number < before ? number : before + side.pieces - number;  // from the side to the apex
    const Index along = (side.from_apex ? side.pieces - k : k) - 1;
    const double t = side.from_apex ? 1.0 - side.fractions[along] : side.fractions[along];
    const Index point = side.first_point + along;
    const FaceNorms::Place place{side.x + t * side.step[0], t * side.step[1]};
    if constexpr (!one_way) return {point, place, side.direction, side.dearer, 0.0, 0.0};
    return {point, place, side.direction, side.dearer, side.shift, side.drift + t * side.drift_step};
  }
  /// Calls `visit` with the numbers of the points that lie beside a part of the side that is crossed, in a
  /// face without height.
  template <typename Visit>
  void for_each_beside(double low, double high, Visit&& visit) const {
    for (const Side& side : side_) {
      double from = 0.0;
      double to = 1.0;
      if (side.step[0] != 0.0) {
        std::tie(from, to) = std::minmax({(low - side.x) / side.step[0], (high - side.x) / side.step[0]});
      } else if (side.x < low || side.x > high) {
        continue;
      }
      if (side.from_apex) std::tie(from, to) = std::pair(1.0 - to, 1.0 - from);
      const auto first = std::ranges::lower_bound(side.fractions, from);
      const auto last = std::ranges::upper_bound(side.fractions, to);
      for (auto at = first; at < last; ++at) {
        const auto along = static_cast<Index>(at - side.fractions.begin()) + 1;
        const Index k = side.from_apex ? side.pieces - along : along;
        visit(&side == &side_[0] ? k : side_[0].pieces + side.pieces - k);
      }
    }
    if (apex_[0] >= low && apex_[0] <= high) visit(side_[0].pieces);
  }
  /// Where a ray from a source through a point of the side meets the other two, as a number between points.
  double position(const FaceNorms::Place& source, double crossing) const {
    const double x = crossing - source[0];
    const double y = -source[1];
    const bool is_second = x * (apex_[1] - source[1]) > y * (apex_[0] - source[0]);
    const Side& side = side_[is_second];
    const double across = x * side.step[1] - y * side.step[0];
    const double t = across != 0.0 ? std::clamp(y * (side.x - crossing) / across, 0.0, 1.0) : 0.0;
    const double k = side.number_at(t);
    return is_second ? side_[0].pieces + side_[1].pieces - k : k;
  }

 private:
  std::array<Side, 2> side_;
  FaceNorms::Place apex_;
  double apex_drift_;
  Index apex_point_;
};

}  // namespace vorogeo
