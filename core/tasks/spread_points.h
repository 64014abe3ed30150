// Points spread over the surface, and moved to the middles of their regions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tasks/means.h"
#include "tasks/workers.h"

namespace vorogeo {

// ---- Points spread over the surface by geodesic distance: farthest point and Poisson-disk sampling

/// When farthest point sampling stops: at whichever comes first.
struct FarthestStop {
  Index count = 0;      ///< this many samples; 0: no such limit
  double radius = 0.0;  ///< every vertex is at most this far from a sample
};

struct FarthestSamples {
  std::vector<SurfacePoint> points;  ///< in the order in which they were taken
  std::vector<double> radius;        ///< distance of each from the previous ones; infinity in a new component
  std::vector<double> distance;      ///< of every vertex from the nearest sample, shape (n)
  /// Greatest entry of `distance` (vertices without a face left out); infinity if a component has no sample.
  double covering_radius = 0.0;
};

/// Farthest point sampling (Gonzalez 1985; on surfaces Moenning, Dodgson 2003): each sample is the vertex
/// farthest from the previous ones, of equally far ones the first; vertices without a face are never taken.
/// So samples are at least the covering radius apart. Begins with the points of `start`, which may lie
/// anywhere, or with one random vertex. There are fewer than `count` samples if all vertices left have
/// distance zero. \throw InvalidInput for a start that is not on the mesh, or if neither a count nor a radius
/// above 0 is given; Cancelled. Complexity: a field for each sample, bounded by the covering radius so far.
FarthestSamples sample_farthest(Surface& surface, const FarthestStop& stop, const PointList& start = {},
                                std::uint64_t seed = 0, const TaskOptions& options = {});

/// Poisson-disk sampling by dart throwing (Cook 1986) over all vertices with a face in random order: samples
/// are at least `radius` apart and no vertex could be added. The result does not depend on the number of
/// threads.
/// \throw InvalidInput for a radius that is not above 0 and finite, Cancelled.
/// Complexity: a field for each sample, bounded by the radius.
std::vector<Index> sample_poisson_disk(Surface& surface, double radius, std::uint64_t seed = 0,
                                       const TaskOptions& options = {});

// ---- Lloyd relaxation: points moved repeatedly to the middle of their geodesic Voronoi regions

struct RelaxedPoints {
  std::vector<SurfacePoint> points;  ///< final position of each point, in the order given
  /// Before the first and after each round: integral over the surface of the squared distance from the
  /// nearest point, in the fourth power of the unit (each vertex represents a third of its faces).
  std::vector<double> energy;
  std::vector<Index> region;  ///< by vertex, the nearest point at the end; no_index where none leads there
};

/// Relaxes points towards a centroidal geodesic Voronoi tessellation (Lloyd 1982; on surfaces Peyre, Cohen
/// 2006). Points may begin anywhere and move to vertices. In a round every point tries the vertex of its
/// region that is nearest in space to the region's centre of mass, or, after a failure, to a point half as
/// far along the line there. All move if that lowers the integral of squared geodesic distances over the
/// surface; otherwise a point stays if the integral over its region would grow, so the energy never rises.
/// Ends after `rounds`, or when no point finds a better vertex; a point that has found none tries again when
/// its region has changed. A point that repeats an earlier one owns no region and waits until that one has
/// moved. \throw InvalidInput for no point or one that is not on the mesh, or negative rounds; Cancelled.
/// Complexity: one or two fields from all points for each round, which may be quick ones. `weights`: of
/// vertices, instead of a third of their faces. `power`: of the distances, by which the energy counts.
RelaxedPoints relax_points(Surface& surface, const PointList& points, Index rounds,
                           const TaskOptions& options = {}, std::span<const double> weights = {},
                           Power power = Power::two);

/// A third of the area of the faces of each vertex; bridges have none.
std::vector<double> vertex_areas(const Mesh& mesh);

}  // namespace vorogeo
