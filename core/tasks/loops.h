// Curves pulled tight, and shortest loops through a point.
#pragma once

#include <string>
#include <vector>

#include "query/path_refine.h"
#include "query/surface.h"
#include "tasks/workers.h"

namespace vorogeo {

/// At most so many rounds pull a loop tight. In a slight neck of a smooth surface, each gains little.
inline constexpr int max_loop_rounds = 5000;

/// A closed curve pulled tight.
struct TightLoop {
  SurfacePath path;    ///< one point, of length 0, if nothing holds the curve: where it slips off
  std::string remark;  ///< that it slips off, or that it was still becoming shorter; empty if neither
};

/// Pulls a closed curve tight until it is a closed geodesic: straight when its faces are laid out flat, and
/// at vertices with at least pi on both sides. It moves continuously and never across a border, so it stays
/// in its homotopy class. `curve` ends where it begins, and consecutive points share a face. From one of its
/// points, the curve is pulled tight as an open line; then from one half-way along, and so on (Birkhoff),
/// until it becomes no shorter. \throw Cancelled at a checkpoint. Complexity: O(faces crossed) for each
/// round; some tens of rounds where it bends at vertices, more in slight necks of smooth surfaces.
TightLoop tightened(const ExactGeometry& geometry, std::vector<SurfacePoint> curve,
                    int max_rounds = max_loop_rounds);

/// The point, validated, through which a loop is wanted. \throw InvalidInput also for a vertex without a
/// face.
SurfacePoint point_of_loop(const Mesh& mesh, const SurfacePoint& given);

/// The closed geodesic that a closed curve through these points is pulled to; see tightened(). If it is not
/// `closed`, the locally shortest path to which the curve is pulled with its ends held. Points that share no
/// face are joined by shortest paths, in a closed curve also the last with the first. `options.answered`
/// receives the loop's remark. \throw InvalidInput for fewer than two points, two that no path joins, a
/// closed curve that slips off (names where), or a metric that jumps.
ExactPath tighten(Surface& surface, const PointList& curve, bool closed = true,
                  const TaskOptions& options = {});

/// The shortest loop through a point that cannot be contracted to it. The edges of the point's cut locus that
/// remain when its ends are pruned fall into classes; for each class, one loop across it is pulled tight with
/// the point held (Erickson, Har-Peled 2004, with exact distances). With a `curve`: the loop from the point
/// by the shortest path to the curve, round it and back is pulled tight instead. \throw InvalidInput as
/// tighten(); where every loop through the point contracts; for a vertex without a face and an edge of three;
/// Cancelled. Complexity: a field, and O(n log n).
ExactPath shortest_loop(Surface& surface, const SurfacePoint& point, const PointList& curve,
                        const TaskOptions& options = {});

}  // namespace vorogeo
