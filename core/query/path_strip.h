// A strip of faces from one surface point to another, each next one across an edge.
#pragma once

#include <array>
#include <vector>

#include "mesh/surface_point.h"

namespace vorogeo {

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

/// Barycentric weights of a point in a face that holds it. \return false if the face does not hold it.
bool weights_in_face(const Mesh& mesh, const SurfacePoint& point, Index face, std::array<double, 3>& weights);

/// Adds faces around `vertex` until the strip ends in `face`; both its last face and `face` have that vertex.
/// Takes the side with the smaller angle. \return false if there is no way around the vertex.
bool turn_around(const Mesh& mesh, FaceStrip& strip, Index vertex, Index face);

/// Takes out detours: a face left and entered again, and faces at the ends that the end points do not need.
void tidy(const Mesh& mesh, FaceStrip& strip);

/// Replaces faces first..last of the strip, all of which have the vertex, by those on its other side.
/// `result` gets the new strip's faces up to `last`. \return false if the vertex's fan is not a cycle.
bool other_side(const Mesh& mesh, const FaceStrip& strip, Index vertex, std::size_t first, std::size_t last,
                FaceStrip& result);

}  // namespace vorogeo
