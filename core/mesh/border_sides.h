// The border edges of a mesh with what decides whether two of them are the sides of one gap.
#pragma once

#include <unordered_map>
#include <vector>

#include "mesh/box_tree.h"
#include "mesh/mesh.h"

namespace vorogeo {

/// An edge with one face.
struct BorderSide {
  Index halfedge;  ///< of the face
  Index tail, head;
  Point
      out;  ///< unit vector in the plane of the face, across the edge and away from the face; 0 without area
  double depth;  ///< height of the face over the edge
};

/// The part of two sides that runs beside each other.
struct SidePair {
  double apart;    ///< their distance in the middle of that part
  double nearest;  ///< in its middle or at one of its ends
  double overlap;  ///< its length
  Point across;    ///< from the first side to the second, in the middle
};

/// All border edges, by numbers of their own. Holds the mesh by reference. Immutable.
class BorderSides {
 public:
  explicit BorderSides(const Mesh& mesh);

  Index count() const { return static_cast<Index>(sides_.size()); }
  const BorderSide& operator[](Index side) const { return sides_[side]; }
  const BoxTree& tree() const { return tree_; }
  Box box(Index side) const;
  const Point& position(Index vertex) const { return mesh_.position(vertex); }

  /// The side between two vertices; no_index if there is none.
  Index between(Index a, Index b) const;
  Index other_end(Index side, Index vertex) const {
    return sides_[side].tail == vertex ? sides_[side].head : sides_[side].tail;
  }
  /// The side that follows at one of its ends, along the faces that it bounds; no_index at a non-manifold
  /// edge.
  Index next(Index side, Index vertex) const;

  /// The point of a side nearest to a position.
  Point nearest_on(Index side, const Point& position) const;
  double distance(Index side, Index vertex) const {
    return distance_between(mesh_.position(vertex), nearest_on(side, mesh_.position(vertex)));
  }
  SidePair beside(Index first, Index second) const;

  /// Whether the surface goes on across a gap from one side to the other (docs/gaps.md): its direction turns
  /// by at most 120 degrees, and `across`, from the first side to the second, does not lead back over the
  /// face of either. `folds`: however much it turns.
  bool continues(Index first, Index second, const Point& across, bool folds) const;

 private:
  const Mesh& mesh_;
  std::vector<BorderSide> sides_;
  std::unordered_map<std::uint64_t, Index> side_between_;
  BoxTree tree_;
};

}  // namespace vorogeo
