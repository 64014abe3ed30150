// The ridge of an exact field: the points that several shortest paths reach.
#pragma once

#include <array>
#include <vector>

#include "exact/exact_solver.h"

namespace vorogeo {

/// Lines over the surface, by points that several of them may share: see ExactSolver::ridge. Without them, a
/// closed surface is one disk for each source: of genus g and from one source, points less edges are 1 - 2 g,
/// and each point where the surface has a border is one more. A line begins at each vertex whose angles lack
/// more than 1e-7 to a full turn, and may run along an edge, where its two faces bring equal waves. Where
/// paths pass along a sharp edge and what is reached by way of it is no wider than rounding, the lines on its
/// two sides meet at the edge's vertices, and the disk is several that touch there.
///
/// On an edge, the places where two waves meet are exact, as the ends of their windows are. In a face, two
/// such places are joined straight, as the line is unless a path has turned; three and more by way of points
/// where three waves meet. Where a region lies within a face, that is split at its sources first.
struct Ridge {
  std::vector<SurfacePoint> points;
  std::vector<std::array<Index, 2>> edges;
  std::vector<double> distance;  ///< by point
  /// By point, between the directions in which shortest paths arrive from two sides of a line, the greatest
  /// of those of its lines; at most pi. At a vertex where a line begins, what its angles lack to a full turn.
  std::vector<double> angle;
};

/// Those edges whose numbers are not marked, and their points.
Ridge without_edges(const Ridge& ridge, const std::vector<bool>& is_gone);

}  // namespace vorogeo
