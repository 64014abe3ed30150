// What closed lines over a surface enclose.
#pragma once

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tasks/cut.h"

namespace vorogeo {

/// In each component with closed lines, the side of these that has no other border of the surface; if both
/// sides have one or neither has, the smaller side. Measures are in the metric of the mesh, which must
/// outlive this object.
class EnclosedPart {
 public:
  /// `cut`: along the lines; `lines`: their name in errors. \throw InvalidInput where the lines have the same
  /// side left and right, as around a handle or a tube. Complexity: O(n log n) for n faces.
  EnclosedPart(const Mesh& mesh, CutMesh cut, const std::string& lines);

  /// The mesh, cut along the lines.
  const CutMesh& cut() const { return cut_; }
  /// Moves the cut mesh out; nothing else may be asked afterwards.
  CutMesh take() { return std::move(cut_); }
  double area() const { return area_; }
  /// Whether a face of the cut is inside.
  bool has(Index face) const { return is_inside_[cut_.region[face]]; }
  std::array<Point, 3> corners(Index face) const;
  /// Whether a point of the mesh lies inside or, but for rounding, on the lines.
  bool holds(const SurfacePoint& point) const;
  /// 1 for a disk.
  Index euler_characteristic() const;

  /// Calls visit(ends, sides of faces) for each edge of the cut.
  template <class Visit>
  void for_each_edge(Visit&& visit) const {
    for (auto next = cut_.sides.begin(); next != cut_.sides.end();) {
      const auto first = next;
      while (next != cut_.sides.end() && next->ends == first->ends) ++next;
      visit(first->ends, std::span(first, next));
    }
  }

 private:
  std::vector<Index> sides() const;

  const Mesh& mesh_;
  CutMesh cut_;
  std::vector<bool> is_inside_;  ///< by region
  double area_ = 0.0;
};

}  // namespace vorogeo
