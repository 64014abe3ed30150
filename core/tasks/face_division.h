// One face divided by lines through it into triangles.
#pragma once

#include <array>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// A face in convex parts, each a cycle of sides, counter-clockwise; neighbouring parts share all points of
/// their common side. Points and lines are added one by one; what is near the last one is found in few steps.
/// The caller numbers the points.
class FaceDivision {
 public:
  using Weights = std::array<double, 3>;
  /// Gives a number to a point where two lines cross.
  using Numbering = std::function<Index(const Weights&)>;

  /// `outline`: corners and points on the sides, in the order of the face.
  FaceDivision(const std::vector<std::pair<Index, Weights>>& outline, Numbering number_of);

  /// Adds a point inside the face, joined to all points of the part around it, unless it was added before.
  void add_point(Index point, const Weights& weights);
  /// Adds a line between two points added before. \return the points that it passes, both ends included; the
  /// line stops before `to` if rounding lets it come no farther.
  std::vector<Index> add_line(Index from, Index to);
  /// All parts divided into triangles, none without area unless the face has none.
  std::vector<std::array<Index, 3>> triangles() const;

 private:
  using Place = std::array<double, 2>;  ///< the weights of the second and the third corner

  struct DividedPoint {
    Index number;
    Place place;
    Index side;  ///< that begins at it; for a point on the outline, the side along that
  };
  struct PartSide {
    Index from;
    Index next, previous;  ///< of the same part
    Index beside;          ///< its opposite in the neighbouring part; no_index on the outline
  };

  /// Above 0 if c is to the left of the line from a to b; 0 if it is on the line, up to rounding.
  static double side_of(const Place& a, const Place& b, const Place& c);
  double side_of(Index a, Index b, Index c) const {
    return side_of(points_[a].place, points_[b].place, points_[c].place);
  }
  Index head(Index side) const { return sides_[sides_[side].next].from; }
  Index new_point(Index number, const Place& place);
  Index new_side(Index from);
  void link(Index side, Index next) { sides_[side].next = next, sides_[next].previous = side; }
  void pair(Index side, Index other) { sides_[side].beside = other, sides_[other].beside = side; }
  template <class Visit>
  void for_each_part_at(Index point, Visit&& visit) const;

  Index part_with(const Place& place);
  bool is_in_part(Index side, const Place& place, Index* exit_side) const;
  Index nearest_side(Index part, const Place& place) const;
  void insert_into_side(Index side, Index point);
  void split(Index side, Index other);
  Index step(Index from, Index to);
  Index cross_part(Index side, Index to);

  std::vector<DividedPoint> points_;
  std::vector<PartSide> sides_;
  std::unordered_map<Index, Index> point_of_;  ///< by number
  Index last_ = 0;                             ///< a side of the part looked at last
  Numbering number_of_;
};

}  // namespace vorogeo
