// A mesh whose faces are split at sources inside them.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "exact/exact_geometry.h"
#include "exact/exact_solver.h"

namespace vorogeo {

/// The same surface with some sources as vertices, so that the region nearest to one of them crosses edges,
/// even where it lies within a single face.
class SplitAtSources {
 public:
  /// Splits faces at the sources inside them; `inside`: the numbers of these sources.
  SplitAtSources(const ExactGeometry& geometry, std::span<const ExactSource> sources,
                 std::span<const Index> inside);

  const std::shared_ptr<const Mesh>& mesh() const { return mesh_; }
  /// All sources, as points of mesh().
  const std::vector<ExactSource>& sources() const { return sources_; }
  /// A point of mesh() as one of the surface that was split.
  SurfacePoint given_point(const SurfacePoint& point) const;

 private:
  using Weights = std::array<double, 3>;

  SurfacePoint point_in_parts(const SurfacePoint& point) const;
  Weights weights_of(Index part, int corner) const;

  const Mesh& given_;
  std::shared_ptr<const Mesh> mesh_;
  std::vector<ExactSource> sources_;
  std::vector<SurfacePoint> added_;             ///< by vertex, from the first added one on
  std::vector<Index> given_face_;               ///< by face
  std::vector<std::array<Index, 2>> parts_of_;  ///< by given face: first part, and the one behind the last
};

/// The Delaunay triangulation of points in a triangle, whose corners are the points 0, 1 and 2, with the
/// others behind them. Triangles are counter-clockwise if the corners are; the sides of the triangle are not
/// divided. Complexity: O(n^2).
std::vector<std::array<Index, 3>> triangulated(std::span<const std::array<double, 2>> points);

}  // namespace vorogeo
