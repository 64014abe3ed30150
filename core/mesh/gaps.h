// Gaps between borders that face each other: vertices that become one, and bridges of faces.
#pragma once

#include <array>
#include <compare>
#include <functional>
#include <memory>
#include <queue>
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_locator.h"
#include "support/types.h"

namespace vorogeo {

// ---- The sides of faces in arrays, as they come before there is a Mesh, edge by edge

/// Whether a face names three vertices. Others are left out of a Mesh.
inline bool is_usable(const std::array<Index, 3>& face) {
  return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}

/// A side of a face, opposite one of its corners.
struct SideOfFace {
  std::array<Index, 2> ends;  ///< vertices, the smaller first
  Index face;
  int corner;

  auto operator<=>(const SideOfFace&) const = default;
};

/// The sides of all usable faces, sorted by ends and then by faces: those of one edge stand together.
std::vector<SideOfFace> sorted_sides(std::span<const std::array<Index, 3>> faces);
/// The same without faces over the same vertices as an earlier one: the sides that a Mesh has.
std::vector<SideOfFace> sides_in_mesh(std::span<const std::array<Index, 3>> faces);

// ---- The border edges of a mesh with what decides whether two of them are the sides of one gap

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

// ---- Bridges over the gaps of a mesh: faces between borders that lie near each other

/// Which gaps are bridged.
struct GapLimit {
  double length = 0.0;  ///< the widest; 0: none, not even where borders touch
  /// Whether borders are also joined where the surface would turn back: rims side by side, sheets above each
  /// other.
  bool folds = false;

  friend bool operator==(const GapLimit&, const GapLimit&) = default;
};

/// \throw InvalidInput for a length that is negative or not finite.
void require_gap(const GapLimit& limit);

/// Border vertices at one position become one vertex, and borders up to the limit apart are joined by
/// triangles between their vertices, so that crossing a gap costs its width. No border of `mesh` is joined to
/// the inside of a face. Empty for a limit of 0. \pre The mesh has no bridges. \throw InvalidInput for a
/// limit that is negative or not finite; Cancelled at a checkpoint. Complexity: O(b log b) for b border
/// edges, if the limit is no more than a few of them long.
GapBridges find_gap_bridges(const Mesh& mesh, const GapLimit& limit);

/// The mesh of these arrays with its gaps bridged. \throw InvalidInput, Cancelled.
std::shared_ptr<const Mesh> bridged_mesh(const std::vector<Point>& positions,
                                         const std::vector<std::array<Index, 3>>& faces,
                                         const GapLimit& limit);

/// The mesh that is measured on: in space with its gaps bridged, or with a metric (`sides` not empty), which
/// jumps at edges if `points_per_edge` is above 0, and for which faces may be split (`splits`). Gap and
/// metric together are refused, as the sides of bridges would have lengths in space. \throw InvalidInput,
/// Cancelled.
std::shared_ptr<const Mesh> measured_mesh(const std::vector<Point>& positions,
                                          const std::vector<std::array<Index, 3>>& faces,
                                          const SideLengths& sides, const GapLimit& limit,
                                          Index points_per_edge = 0, const FaceSplits& splits = {});

/// The least limit with which all faces are one component; `unreachable` if none would do.
/// Complexity: O(b log b log c) for c components.
double gap_to_join_all(const Mesh& mesh, bool folds);

/// How many border loops of a mesh (mesh_check.h) have an edge that is no border once its gaps are bridged.
Index count_joined_borders(const Mesh& mesh, const Mesh& bridged);

// ---- Closes gaps between borders like a zipper: triangles from vertex to vertex, along both of them

/// Makes the triangles between borders. Each border edge becomes the side of one triangle at most.
class GapZipper {
 public:
  GapZipper(const Mesh& mesh, const BorderSides& sides, const GapLimit& limit)
      : mesh_(mesh), sides_(sides), limit_(limit), used_(sides.count(), 0) {}

  /// Two sides that run beside each other, `apart` from each other: rows of triangles may begin there.
  void add_start(double apart, Index first, Index second) { starts_.push_back({apart, first, second}); }
  /// Bridges the gaps: at every moment the row of triangles grows, or begins, where the gap is narrowest, so
  /// that where several gaps meet each border is joined to the one across and not to one round the corner.
  void close();
  /// Small holes that are left where several gaps meet.
  void fill_holes();

  std::vector<std::array<Index, 3>> take_faces() { return std::move(faces_); }

 private:
  /// The end of a row of triangles: a vertex of each border and the sides that leave them.
  struct Front {
    Index p, q;
    Index from_p, from_q;  ///< no_index: that border ends
    Index last_p, last_q;  ///< the sides passed last, which give the directions where a border ends
  };

  /// A pair of sides to begin at.
  struct Start {
    double apart;
    Index first, second;
    auto operator<=>(const Start&) const = default;
  };
  /// A row that grows next where the gap is `apart` wide.
  struct Growing {
    double apart;
    std::size_t number;  ///< for an order of its own
    Front front;
    bool operator>(const Growing& other) const {
      return apart != other.apart ? apart > other.apart : number > other.number;
    }
  };

  Front front_between(Index first, Index second) const;
  void begin(const Start& start);
  void begin_at_corner(Front front);
  /// Width of the gap at the next vertex of one border; `unreachable` if the row may not go on to it.
  double next_width(Index side, Index from, Index opposite, Index opposite_side, Index last,
                    Index last_own) const;
  double next_width_p(const Front& front) const {
    return next_width(front.from_p, front.p, front.q, front.from_q, front.last_q, front.last_p);
  }
  double next_width_q(const Front& front) const {
    return next_width(front.from_q, front.q, front.p, front.from_p, front.last_p, front.last_q);
  }
  void push(const Front& front);
  void grow(Front front);
  void advance(Index& vertex, Index& side, Index& last, Index opposite);
  bool is_free(Index side) const { return side != no_index && used_[side] == 0; }
  Index free_next(Index side, Index vertex) const;

  const Mesh& mesh_;
  const BorderSides& sides_;
  GapLimit limit_;
  std::vector<std::uint8_t> used_;  ///< by side
  std::vector<Start> starts_;
  std::priority_queue<Growing, std::vector<Growing>, std::greater<>> growing_;
  std::size_t pushed_ = 0;
  std::vector<std::array<Index, 3>> faces_;
  std::vector<std::array<Index, 2>> ends_;  ///< edges at which rows of triangles end
};

}  // namespace vorogeo
