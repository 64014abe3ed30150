// The shortest line inside a strip of faces, unfolded into the plane.
#pragma once

#include <array>
#include <vector>

#include "exact/exact_geometry.h"
#include "query/path_strip.h"

namespace vorogeo {

using PlanePoint = std::array<double, 2>;

/// A vertex at which the line bends, on one side of the strip.
struct Bend {
  Index vertex;
  bool left;
  PlanePoint at;
  std::size_t crossing;  ///< one of the crossings that end in the vertex
};

/// An unfolded edge between two faces of the strip, as one sees it going from source to target.
struct UnfoldedEdge {
  Index left;
  Index right;
  PlanePoint at_left;
  PlanePoint at_right;
};

/// Unfolds a strip and pulls a string tight in it (Lee, Preparata 1984). Keeps its memory between calls.
class Funnel {
 public:
  /// Complexity: O(faces of the strip).
  void pull(const ExactGeometry& geometry, const FaceStrip& strip);

  double length() const { return length_; }
  /// Where the line bends, in order.
  const std::vector<Bend>& bends() const { return bends_; }
  const std::vector<UnfoldedEdge>& edges() const { return edges_; }
  const PlanePoint& source() const { return source_; }
  const PlanePoint& target() const { return target_; }
  /// End points of the straight pieces: source, bends, target. `piece` counts from 0.
  const PlanePoint& piece_begin(std::size_t piece) const {
    return piece == 0 ? source_ : bends_[piece - 1].at;
  }
  const PlanePoint& piece_end(std::size_t piece) const {
    return piece == bends_.size() ? target_ : bends_[piece].at;
  }

 private:
  struct Node {
    PlanePoint at;
    std::size_t parent;
    Index vertex;
    std::size_t crossing;
    bool left;
  };
  void unfold(const ExactGeometry& geometry, const FaceStrip& strip);
  std::size_t add(const PlanePoint& point, bool left, Index vertex, std::size_t crossing);

  std::vector<UnfoldedEdge> edges_;
  std::vector<Bend> bends_;
  PlanePoint source_{};
  PlanePoint target_{};
  double length_ = 0.0;
  std::vector<Node> nodes_;
  std::vector<std::size_t> funnel_;  ///< nodes from left to right
  std::size_t head_ = 0;
  std::size_t tail_ = 0;
  std::size_t apex_ = 0;
};

}  // namespace vorogeo
