// One face divided by lines through it into triangles.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// A face in convex parts, each a cycle of points, counter-clockwise; parts side by side share all points of
/// their common side. Lines are added one by one. Points have numbers of the caller's.
class FaceDivision {
 public:
  using Weights = std::array<double, 3>;
  /// Gives a number to a point where two lines cross.
  using Numbering = std::function<Index(const Weights&)>;

  /// `outline`: corners and points on the sides, in the order of the face.
  FaceDivision(const std::vector<std::pair<Index, Weights>>& outline, Numbering number_of);

  /// A point inside the face, joined to all around it. Nothing happens if it is there.
  void add_point(Index point, const Weights& weights);
  /// A line between two points that are there. \return the points that it passes, both ends among them; it
  /// ends early if rounding lets it come no farther.
  std::vector<Index> add_line(Index from, Index to);
  /// All parts in triangles, none without area unless the face has none.
  std::vector<std::array<Index, 3>> triangles() const;

 private:
  using Part = std::vector<Index>;
  using Place = std::array<double, 2>;  ///< the weights of the second and the third corner

  /// Above 0 if c is to the left of the way from a to b; 0 if it is on it but for rounding.
  double side_of(Index a, Index b, Index c) const;
  double area_of(const Part& part) const;
  void insert_into_side(Index a, Index b, Index point);
  void split(std::size_t part, std::size_t i, std::size_t j);
  Index step(Index from, Index to);
  Index cross_part(std::size_t part, std::size_t corner, Index to);

  std::map<Index, Place> place_;
  std::vector<Part> parts_;
  Numbering number_of_;
};

}  // namespace vorogeo
