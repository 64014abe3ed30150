// A strip of faces from one surface point to another, each adjacent to the next across an edge.
#pragma once

#include <array>
#include <vector>

#include "mesh/surface_point.h"

namespace vorogeo {

/// An edge as half-edge of the face that is left and of the face that is entered.
struct HalfedgePair {
  Index exit;
  Index entry;
};

/// Faces in order; `entry[i]` is the half-edge of faces[i + 1] by which it is entered, `exit[i]` the one of
/// faces[i] on the same edge.
struct FaceStrip {
  SurfacePoint source;
  SurfacePoint target;
  std::vector<Index> faces;
  std::vector<Index> entry;
  std::vector<Index> exit;

  void clear();
  void push(Index face, Index exit_halfedge, Index entry_halfedge);
};

/// Adds faces around `vertex` until the strip ends in `face`; both its last face and `face` have that vertex.
/// Takes the side with the smaller angle. \return false if the faces are not connected around the vertex.
bool turn_around(const Mesh& mesh, FaceStrip& strip, Index vertex, Index face);

/// Removes detours: faces left and entered again at once, and faces at the ends that the end points do not
/// need.
void tidy(const Mesh& mesh, FaceStrip& strip);

/// The path around `vertex` from the face of half-edge `exit`, which ends at it, to `face`, on the side where
/// that half-edge is not crossed. Adds the crossings to `passed`. \return false if the vertex's fan is not a
/// cycle.
bool other_side(const Mesh& mesh, Index vertex, Index exit, Index face, std::vector<HalfedgePair>& passed);

}  // namespace vorogeo
