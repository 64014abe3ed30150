// A strip of faces, and the shortest line in it, which can be moved to the other side of vertices.
#pragma once

#include <array>
#include <vector>

#include "exact/exact_geometry.h"
#include "mesh/surface_point.h"
#include "mesh/vectors.h"
#include "support/types.h"

namespace vorogeo {

// ---- A strip of faces from one surface point to another, each adjacent to the next across an edge

/// A crossed edge, as half-edge of the face that is left and of the face that is entered.
struct HalfedgePair {
  Index exit;
  Index entry;
};

/// Where a path goes from face to face.
struct FaceStrip {
  SurfacePoint source;
  SurfacePoint target;
  Index first = no_index;               ///< face; no_index as long as there is none
  std::vector<HalfedgePair> crossings;  ///< from each face to the next one

  Index last() const { return crossings.empty() ? first : Mesh::face_of(crossings.back().entry); }
};

/// Adds faces around `vertex` until the strip ends in `face`; both its last face and `face` have that vertex.
/// Takes the side with the smaller angle. \return false if the faces are not connected around the vertex.
bool turn_around(const Mesh& mesh, FaceStrip& strip, Index vertex, Index face);

/// The path around `vertex` from the face of half-edge `exit`, which ends at it, to `face`, on the side where
/// that half-edge is not crossed. Adds the crossings to `passed`. \return false if the vertex's fan is not a
/// cycle.
bool other_side(const Mesh& mesh, Index vertex, Index exit, Index face, std::vector<HalfedgePair>& passed);

// ---- The shortest line through a row of gates in the plane

/// Pulls a string tight between two points through gates (Lee, Preparata 1984). Keeps its memory.
class Funnel {
 public:
  /// Where the string bends: which gate brought the point, and on which side.
  struct Bend {
    Index gate;
    bool left;
  };

  /// Begins at a point, with room for the ends of this many gates.
  void reset(const PlanePoint& point, std::size_t gates);
  /// The next gate has a new end on its left, or on its right, as seen from the start.
  void add_left(const PlanePoint& point, Index gate);
  void add_right(const PlanePoint& point, Index gate);
  /// Ends at a point. \return the bends in order, valid until reset(). Complexity of all calls: O(gates).
  const std::vector<Bend>& finish(const PlanePoint& point);

 private:
  struct Node {
    std::uint32_t parent;
    Bend bend;
  };
  struct Slot {
    PlanePoint at;
    std::uint32_t node;
  };
  std::vector<Node> nodes_;
  std::vector<Slot> funnel_;  ///< from left to right
  std::vector<Bend> bends_;
  std::size_t head_ = 0;
  std::size_t tail_ = 0;
  std::size_t apex_ = 0;
};

// ---- A strip of faces unfolded piece by piece, and the shortest line in it

/// The crossing from one face of a strip to the next.
struct UnfoldedCrossing {
  Index exit;   ///< half-edge of the face that is left
  Index entry;  ///< half-edge of the face that is entered, on the same edge
  Index left;   ///< ends of the edge as seen when going from source to target
  Index right;
  double along;  ///< third corner of the face entered, in units of the edge's length: from left to right
  double aside;  ///< and beyond the edge
  double corner_distance;  ///< if the edge has no length, and so no direction: distance of the corner, in any
                           ///< direction
  PlanePoint at_left;
  PlanePoint at_right;

  /// The third corner, in the plane of the two ends.
  PlanePoint apex() const {
    const double ux = at_right[0] - at_left[0];
    const double uy = at_right[1] - at_left[1];
    return {at_left[0] + ux * along - uy * aside + corner_distance, at_left[1] + uy * along + ux * aside};
  }
};

inline Index size_of(const std::vector<UnfoldedCrossing>& crossings) {
  return static_cast<Index>(crossings.size());
}

/// Source, target, and each vertex at which the line bends. The crossings up to `last` are unfolded into the
/// plane of the preceding ones, the others into the plane of the following ones; `last` is known in both.
struct Joint {
  Index vertex = no_index;  ///< no_index for source and target
  bool left = true;         ///< on which side of the strip the vertex is
  bool settled = false;     ///< the other side is not shorter
  bool is_seam = false;     ///< the two planes are not the same
  Index first = 0;          ///< first and last of the crossings that end in the vertex
  Index last = 0;
  PlanePoint in{};        ///< the vertex in the preceding plane
  PlanePoint other_in{};  ///< and the other end of the last crossing
  PlanePoint out{};       ///< the vertex in the following plane
  PlanePoint other_out{};
};

/// The shortest line in a strip. It can be changed locally: only the part between two joints that stay is
/// unfolded and pulled tight again.
class PathLine {
 public:
  explicit PathLine(const ExactGeometry& geometry) : geometry_(&geometry) {}

  /// Copies another line on the same mesh.
  void assign(const PathLine& other);
  /// Takes over a strip, without its detours and the faces at its ends that the end points do not need, and
  /// pulls the line tight. Complexity: O(faces).
  void assign(const FaceStrip& strip);

  const std::vector<UnfoldedCrossing>& crossings() const { return crossings_; }
  /// From source to target.
  std::vector<Index> faces() const;
  /// In order, with source and target.
  const std::vector<Joint>& joints() const { return joints_; }
  const SurfacePoint& source() const { return source_; }
  const SurfacePoint& target() const { return target_; }
  /// Whether the edges that the line crosses, or crossed before a change, differ so much in length from each
  /// other or from the line that unfolding loses the line's length: a position is rounded by a part of the
  /// longest edge, and a direction by that over the shortest.
  bool is_rough() const;
  double length() const;
  /// Angle by which the line turns towards the vertex of a joint; negative if the bend is not needed.
  double turn(std::size_t joint) const;
  /// Sets the range of a joint: all consecutive crossings around `at` that end in its vertex, on its side.
  void find_range(Index at, Joint& joint) const;

  /// What to do at a joint: `keep` the bend; `release` it, so that the line is pulled tight between the
  /// joints around it; `flip`: also move the strip to the other side of the vertex.
  enum class Change : std::uint8_t { keep, release, flip };
  /// Applies `changes`, one entry for each joint; joints too close to a flip are released. \return the number
  /// of flips done. Complexity: O(crossings) for copying, and unfolding of the pieces changed.
  int change(std::vector<Change>& changes);
  /// Moves the strip to the other side of a vertex that is not a joint but lies between joint `piece` and the
  /// next one.
  bool flip_beside(std::size_t piece, const Joint& beside);
  void settle(std::size_t joint) { joints_[joint].settled = true; }

 private:
  UnfoldedCrossing crossing_at(Index exit, Index entry, Index left, Index right);
  void push(const UnfoldedCrossing& crossing);
  void copy(Index begin, Index end);
  bool push_other_side(const Joint& joint);
  Index trim_ends();
  void release_neighbours(std::vector<Change>& changes) const;
  int rebuild(std::vector<Change>& changes);
  void extend(Joint& joint);
  void pull(Joint& from, Joint& to);

  const ExactGeometry* geometry_;
  SurfacePoint source_;
  SurfacePoint target_;
  Index first_face_ = no_index;
  std::vector<UnfoldedCrossing> crossings_;
  std::vector<Joint> joints_;
  double shortest_crossed_ = unreachable;
  double longest_crossed_ = 0.0;

  // Used only during a change.
  Funnel funnel_;
  std::vector<UnfoldedCrossing> next_;
  std::vector<Joint> next_joints_;
  std::vector<HalfedgePair> passed_;
  Index fixed_ = 0;         ///< number of crossings of next_ up to the last joint that stays
  bool disturbed_ = false;  ///< one of them was taken out
};

}  // namespace vorogeo
