// Obtuse corners of a mesh, split by a vertex that unfolding finds inside them.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// A triangle in the plane, as fast marching sees it from a corner: two vertices with known values, their
/// distances from the corner's vertex and the angle between them there.
struct MarchingTriangle {
  Index vertex;         ///< the corner's, which gets a value
  Index first, second;  ///< which have one
  double to_first, to_second;
  double cosine;  ///< of the angle at the corner; negative only where no split was found
};

/// The triangles at all corners of the mesh. A corner of more than 90 degrees is split: the faces opposite to
/// it are unfolded one after the other until a vertex lies in the sector that leaves two acute angles
/// (Kimmel, Sethian 1998, section 4, "extending to non-acute triangulations"). Where the strip meets a border
/// of the mesh or a non-manifold edge first, or after `max_unfolded` faces, the obtuse triangle stays.
std::vector<MarchingTriangle> marching_triangles(const Mesh& mesh);

inline constexpr int max_unfolded = 64;

}  // namespace vorogeo
