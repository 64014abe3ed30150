// Lloyd relaxation: points moved repeatedly to the middle of their geodesic Voronoi regions.
#pragma once

#include <span>
#include <vector>

#include "support/progress.h"
#include "tasks/field_team.h"

namespace vorogeo {

struct RelaxedPoints {
  std::vector<SurfacePoint> points;  ///< final position of each point, in the order given
  std::vector<Index> vertices;       ///< the same as vertices; no_index for a point that stayed inside a face
  /// Before the first and after each round: integral over the surface of the squared distance from the
  /// nearest point, in the fourth power of the unit (each vertex represents a third of its faces).
  std::vector<double> energy;
};

/// Relaxes points towards a centroidal geodesic Voronoi tessellation (Lloyd 1982; on surfaces Peyre, Cohen
/// 2006). Points may begin anywhere and move to vertices. In a round every point tries the vertex of its
/// region that is nearest in space to the region's centre of mass, or, after a failure, to a point half as
/// far along the line there; it moves if that lowers the integral of squared geodesic distances over its
/// region, so the energy never rises (beyond the errors of the fields). Ends after `rounds`, or when no point
/// finds a better vertex. A point that repeats an earlier one owns no region and waits until that one
/// has moved. \throw InvalidInput for no point or one that is not on the mesh, or negative rounds; Cancelled.
/// Complexity: two fields for each point and round, bounded by the regions' size.
RelaxedPoints relax_points(FieldTeam& team, const PointList& points, Index rounds,
                           const Progress& progress = {});

}  // namespace vorogeo
