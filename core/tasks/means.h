// Points in the middle of others: means, medians and medoids of weighted points.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tasks/workers.h"

namespace vorogeo {

/// Which power of the distances is summed.
enum class Power : std::uint8_t { one = 1, two = 2 };

inline double powered(double distance, Power power) {
  return power == Power::two ? distance * distance : distance;
}

/// A point from which the weighted sum of powers of the distances to some points is least.
struct Centre {
  SurfacePoint point;
  double energy = 0.0;  ///< this sum
  std::string remark;   ///< if other points are as good, or the descent did not settle; otherwise empty
};

/// One weight for each of `count` points, all 1 if none are given. \throw InvalidInput for another number of
/// them, for one that is negative or not finite, and if none is above 0.
std::vector<double> checked_weights(std::span<const double> weights, std::size_t count);

/// The point with the least sum of weighted squared distances (Frechet mean, Karcher 1977), or of weighted
/// distances (geometric median), near the best of the given points; without weights, all count 1. Where the
/// sum is smooth, the paths give both of its derivatives (see Query::first_turns), and the descent takes
/// Newton's step, halved until the sum falls; it may also end at a vertex where paths turn, on a border, or
/// at a given point. Ends when steps are shorter than 1e-9 of the distance of the farthest point. If up to
/// four of the given points are equally good, it begins at each of them; the remark says if their descents
/// end apart at equal sums. \throw InvalidInput for no point, weights as checked_weights(), points that no
/// path joins (names two), where directions have no angles (log_map()); Cancelled. Complexity: medoid() and
/// some ten fields, exact and bounded by the distances of the points.
Centre centre_of(Surface& surface, const PointList& points, std::span<const double> weights, Power power,
                 const TaskOptions& options = {});

/// The descent of centre_of() from one point; all points are within `reach` of it. \pre Points are on the
/// mesh, canonical, in one component, their weights above 0.
Centre descend(Surface& surface, const SurfacePoint& start, const PointList& points,
               std::span<const double> weights, Power power, double reach, int threads,
               const Progress& progress = {});

/// The position of the given point with the least sum of weighted distances from all; of equal ones, the
/// first. \throw InvalidInput for no point, bad weights, or points that no path joins; Cancelled. Complexity:
/// a field for each point that the triangle inequality does not rule out, of spread points about the square
/// root of their number (Newling, Fleuret 2017).
Index medoid(Surface& surface, const PointList& points, std::span<const double> weights,
             const TaskOptions& options = {});

/// For each point, the weighted sum of powers of its distances from all; infinite for points that are ruled
/// out. `row`: the distances of all points from any point, if known. \pre as descend(), but weights may be 0.
std::vector<double> least_energies(Workers& workers, const PointList& points, std::span<const double> weights,
                                   Power power, std::span<const double> row, const Progress& progress);

}  // namespace vorogeo
