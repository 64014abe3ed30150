// Smooth curves: points along a path, Bezier curves and splines, by exact shortest paths.
#pragma once

#include <span>
#include <vector>

#include "tasks/workers.h"

namespace vorogeo {

/// The points at fractions of the length of a path. \throw InvalidInput for an empty path, a point that is
/// not on the mesh, two consecutive ones without a common face (names them), a fraction outside [0, 1].
/// Complexity: O(points + fractions log points).
std::vector<SurfacePoint> points_along(const Mesh& mesh, const PointList& path,
                                       std::span<const double> fractions);

/// The points of a path, then those that divide it into equal steps of at most `spacing`. \throw InvalidInput
/// also for a spacing that is not above 0 or makes more than ten million points.
std::vector<SurfacePoint> steps_along(const Mesh& mesh, const PointList& path, double spacing);

/// The Bezier curve of control points by de Casteljau's construction, whose straight lines are shortest paths
/// (Park, Ravani 1995): at `samples` + 1 parameters from 0 to 1, which shortest paths join. \throw
/// InvalidInput for fewer than two points, one that is not on the mesh, two that no path joins (names both),
/// fewer than one sample; NotEnoughMemory; Cancelled. Complexity: for each sample an exact path for each pair
/// of points on each level but the first.
ExactPath bezier(Surface& surface, const PointList& points, Index samples, const TaskOptions& options = {});

/// The uniform cubic B-spline curve of control points, closed or from the first one to the last, by
/// subdivision (Lane, Riesenfeld 1980; on surfaces Mancinelli et al. 2022): on each level, each point is
/// doubled, then three times all are replaced by the middles of the shortest paths between neighbours.
/// Shortest paths join the points of the last level. \throw InvalidInput as bezier(), for fewer than one
/// level and fewer than three points of a closed one. Complexity: on level i, some 2^i exact paths for each
/// point, half as long as on the one before.
ExactPath b_spline(Surface& surface, const PointList& points, bool closed, Index levels,
                   const TaskOptions& options = {});

/// A curve through all points, closed or not: between two neighbours a cubic Bezier curve of `samples` parts,
/// whose direction at a point is half of the difference of the vectors to the next one and to the one before
/// (Catmull, Rom 1974), at an end the vector to its neighbour. \throw InvalidInput as bezier(), at a point
/// where directions have no angles, for fewer than three points of a closed one.
ExactPath spline(Surface& surface, const PointList& points, bool closed, Index samples,
                 const TaskOptions& options = {});

}  // namespace vorogeo
