// Eccentricity, diameter and disks, and how two fields differ.
#pragma once

#include <vector>

#include "tasks/workers.h"

namespace vorogeo {

// ---- How two distance fields of one mesh differ

/// Signed relative differences at the vertices that have a distance in both fields, and their statistics.
struct FieldDifference {
  std::vector<double> relative;  ///< NaN where there is nothing to compare
  int compared = 0;
  int one_only = 0;  ///< vertices with a distance in only one of the fields
  double bias = 0.0;
  double mean = 0.0;
  double rms = 0.0;
  double p99 = 0.0;
  double max = 0.0;
};

/// Complexity: O(n log n). \pre Both have the same size.
FieldDifference difference_of(const std::vector<double>& values, const std::vector<double>& reference);

// ---- How far a surface reaches: eccentricities, bounds of diameter and radius, the centre, and disks

/// The eccentricity of each point within its component. \throw InvalidInput for a point that is not on the
/// mesh, Cancelled.
/// Complexity: a field for each.
std::vector<Eccentricity> eccentricities(Surface& surface, const PointList& points,
                                         const TaskOptions& options = {});

/// A number known to lie between two bounds.
struct Bounds {
  double lower = 0.0;
  double upper = unreachable;
};

/// The greatest and the least eccentricity of the vertices of a component.
struct Extent {
  Bounds diameter;
  Index ends[2] = {no_index, no_index};  ///< vertices whose distance is the lower bound of the diameter
  Bounds radius;
  Index centre = no_index;  ///< a vertex whose eccentricity is the upper bound of the radius
  Index fields = 0;         ///< how many were computed
};

/// Bounds from at most `max_fields` fields, in the component of `start`: a double sweep, then alternately
/// from the vertex whose eccentricity may still be the greatest and from the one whose may still be the
/// least; the triangle inequality bounds the eccentricities of all others (Takes, Kosters 2011). The bounds
/// hold for the distances as computed and meet if enough fields are allowed. \throw InvalidInput for a start
/// out of range or fewer than 2 fields, Cancelled.
Extent extent_of_component(Surface& surface, Index start, Index max_fields, const TaskOptions& options = {});

/// The vertices and faces within a radius of the sources, by their numbers as given. \throw InvalidInput for
/// no source, one that is not on the mesh, or a radius that is negative or NaN.
Disk geodesic_disk(Surface& surface, const PointList& sources, double radius,
                   const TaskOptions& options = {});

}  // namespace vorogeo
