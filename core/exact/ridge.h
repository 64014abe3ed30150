// The ridge of an exact field: the points that several shortest paths reach.
#pragma once

#include <array>
#include <vector>

#include "exact/exact_solver.h"

namespace vorogeo {

/// Lines over the surface, by points that several of them may share: see ExactSolver::ridge. Cut along them,
/// a surface becomes one disk for each source: the number of points less that of edges is the Euler
/// characteristic less the number of sources, plus one for each point on a border of the mesh. A line begins
/// at each vertex whose angle defect exceeds 1e-7, and may run along an edge whose two faces bring equal
/// waves. Where paths pass along a sharp edge and what is reached by way of it is no wider than rounding, the
/// lines on its two sides meet at the edge's vertices, and the disk becomes several that touch there.
///
/// On an edge, the places where two waves meet are exact, as the ends of windows are. In a face, two such
/// places are joined straight, as the line is unless a path has turned; three or more are joined by points
/// where three waves meet. A face in which a whole region lies is split at its sources first.
struct Ridge {
  std::vector<SurfacePoint> points;
  std::vector<std::array<Index, 2>> edges;
  std::vector<double> distance;  ///< by point
  /// By point: the angle between the directions in which shortest paths arrive from the two sides of a line,
  /// the greatest over the point's lines; at most pi. At a vertex where a line begins, its angle defect.
  std::vector<double> angle;
};

/// The ridge of the edges that are not marked, with their points only.
Ridge without_edges(const Ridge& ridge, const std::vector<bool>& is_gone);

}  // namespace vorogeo
