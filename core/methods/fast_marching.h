// Fast marching, with obtuse corners unfolded.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "methods/method.h"

namespace vorogeo {

// ---- Obtuse corners of a mesh, split by a vertex that unfolding finds inside them

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

// ---- Fast marching on triangles

/// Plane waves through the triangles of a mesh, in order of arrival.
class FastMarching final : public GeodesicMethod {
 public:
  explicit FastMarching(const std::shared_ptr<const Mesh>& mesh);
  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override;
  std::size_t bytes() const override;

 private:
  Index vertices_;
  std::vector<MarchingTriangle> triangles_;
  std::vector<std::size_t> begin_;
  std::vector<std::size_t> seen_from_;
};

}  // namespace vorogeo
