// Directions at points: the logarithmic and the exponential map, and the frames they count in.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exact/straightest.h"
#include "tasks/workers.h"

namespace vorogeo {

/// The geometry from which angles at a point are read. \throw InvalidInput in a component where the metric
/// jumps at edges. \pre The point is on the mesh.
const ExactGeometry& agreeing_geometry(Surface& surface, const SurfacePoint& point);

/// The frames at points, in space: x axis, y axis and normal of each (TangentFrame::axes). \throw
/// InvalidInput for a point that is not on the mesh, or at which directions have no angles; in a face that
/// the metric measures in parts; in a component where the metric jumps at edges; with any metric, as its
/// angles are not those in space; where faces have no normal.
std::vector<std::array<Point, 3>> tangent_frames(Surface& surface, const PointList& points);

/// The shortest paths from a point to some points, or to all vertices, as vectors in the frame there;
/// distances above max_distance are `unreachable`. Exact, unless `by` is an index: see IndexField::first_leg.
/// \throw as tangent_frames(), but takes a metric; for `by` quick and for a negative distance; Cancelled.
/// Complexity: that of an exact field, bounded by the farthest target if all are vertices; from an index two
/// to three of its fields.
LogMap log_map(Surface& surface, const SurfacePoint& point, const std::optional<PointList>& targets,
               double max_distance, const TaskOptions& options);

/// The gradient of the distance from the nearest source, at all vertices given or at some points: vectors of
/// length 1 in the frames there, away from the source, against the direction in which the shortest path to it
/// begins. NaN at sources, where no path leads, beyond max_distance, and at vertices without a frame. Always
/// exact; where several paths are shortest, of one of them. \throw as log_map(), and for points without a
/// frame. Complexity: an exact field that keeps its windows.
std::vector<Tangent> gradient(Surface& surface, const PointList& sources,
                              const std::optional<PointList>& points, double max_distance,
                              const TaskOptions& options);

/// Vectors at the first point of a path, carried along it in parallel to its last point: in the faces they
/// keep their angle with the path, at a vertex their direction in its frame. \throw InvalidInput for an empty
/// path, a point that is not on the mesh or has no frame, two consecutive ones without a common face (names
/// them). Complexity: O(points).
std::vector<Tangent> transport(Surface& surface, const PointList& path, const std::vector<Tangent>& vectors);

/// A vector at a point, carried along the shortest paths to all vertices given, in the frames there. NaN
/// where no path leads, beyond max_distance, at vertices without a frame and where the path crosses a place
/// without one. Always exact; where several paths are shortest, along one of them. \throw as log_map(), and
/// for a vector that is not finite. Complexity: an exact field that keeps its windows, and O(faces that the
/// paths cross between the vertices where they turn).
std::vector<Tangent> transport_from(Surface& surface, const SurfacePoint& point, const Tangent& vector,
                                    double max_distance, const TaskOptions& options);

/// The ends of straightest lines from points along vectors in the frames there, on all threads: a line for
/// each pair, or from one point along each vector. \throw as log_map(), for vectors that are not finite and
/// for lists of different lengths; Cancelled. Complexity: O(faces crossed).
std::vector<TracedEnd> exp_map(Surface& surface, const PointList& points, const std::vector<Tangent>& vectors,
                               AtBorder at_border, const TaskOptions& options);

}  // namespace vorogeo
