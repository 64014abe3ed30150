// Corners of a face in its plane, from the frame of its first half-edge.
#include "exact/face_plane.h"

namespace vorogeo {

FacePlane::FacePlane(const ExactGeometry& geometry, Index face) {
  const Mesh& mesh = *geometry.mesh;
  const FaceFrame& frame = geometry.frame[3 * face];
  const Index edge = mesh.edge_of(3 * face);
  const double length = mesh.edge_length(edge);
  // The origin is where positions on the edge count from: at the other end, digits may be lost.
  const bool along = geometry.ends(edge)[0] == mesh.face_vertices(face)[0];
  corner[0] = {along ? 0.0 : -length, 0.0};
  corner[1] = {along ? length : 0.0, 0.0};
  corner[2] = {along ? frame.apex_x : -frame.apex_x, frame.apex_depth};
  // Two corners at one place: the third is as far from both, in any direction.
  if (!(length > 0.0)) corner[2] = {mesh.edge_length(mesh.edge_of(3 * face + 1)), 0.0};
}

std::array<double, 2> FacePlane::at(const std::array<double, 3>& barycentric) const {
  std::array<double, 2> point{};
  for (int i = 0; i < 3; ++i) {
    point[0] += barycentric[i] * corner[i][0];
    point[1] += barycentric[i] * corner[i][1];
  }
  return point;
}

}  // namespace vorogeo
