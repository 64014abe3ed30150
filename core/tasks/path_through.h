// Paths through several points: shortest from each to the next, and back to the first where they are closed.
#pragma once

#include <string>
#include <vector>

#include "query/surface.h"
#include "tasks/workers.h"

namespace vorogeo {

/// The shortest path through the points in this order, each leg exact. `closed`: and from the last back to
/// the first, so that it begins and ends there. Certified where all legs are: it is then the shortest that
/// passes the points in this order. \throw InvalidInput for fewer than two points, one that is not on the
/// mesh, or two that no path joins (names both by their position in the list); Cancelled. Complexity: an
/// exact path for each leg.
ExactPath path_through(Surface& surface, const PointList& points, bool closed,
                       const TaskOptions& options = {});

/// The exact shortest paths from each of some points on the mesh to the next, and where `closed` from the
/// last to the first. Their time is added to that in `options.answered`. \throw InvalidInput for two that no
/// path joins; Cancelled.
std::vector<ExactPath> legs_between(Surface& surface, const PointList& points, bool closed,
                                    const TaskOptions& options);
/// The same for given pairs of neighbours in a list; `closed`: the last target is its first point.
std::vector<ExactPath> legs_between(Surface& surface, const PointPairs& ends, bool closed,
                                    const TaskOptions& options);

/// A point as sentences name it: by its vertex, or by its face.
std::string name_of(const Mesh& mesh, const SurfacePoint& point);

/// Refuses two points of a list that no path joins, by their positions in it. \throw InvalidInput.
[[noreturn]] void refuse_leg(const Mesh& mesh, std::size_t i, const SurfacePoint& from, std::size_t j,
                             const SurfacePoint& to);

/// Refuses point i of a path, which shares no face with the one before. \throw InvalidInput.
[[noreturn]] void refuse_step(const Mesh& mesh, const PointList& path, std::size_t i);

}  // namespace vorogeo
