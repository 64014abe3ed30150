// Geodesic Voronoi regions of chosen points: labels, areas, and borders that cross the faces.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "support/progress.h"
#include "tasks/field_team.h"
#include "tasks/surface_lines.h"

namespace vorogeo {

/// Regions are positions in the list of sites; no_index where no site can be reached.
struct VoronoiRegions {
  std::vector<Index> vertex_region;  ///< of the nearest site; of equally near ones, the first
  std::vector<double> distance;      ///< of each vertex from its site
  std::vector<Index> face_region;    ///< the region at the face's centre; see central_parts() for split faces
  std::vector<double> area;          ///< of each region, in the square of the mesh's unit
  SurfaceLines borders;
  /// The two regions at each segment of the borders, the smaller one first.
  std::vector<std::array<Index, 2>> border_regions;
};

/// Regions of the sites by the fields of `team`. A site that repeats an earlier one owns nothing.
///
/// In a face, the difference of the squares of two distances is interpolated linearly between the corners,
/// which is exact on flat parts of the surface. A site owns the points at which its square is the least, so
/// borders continue over edges, and three or more regions may meet in a face. Where the metric jumps, the
/// same holds for parts of faces (DividedFaces). A region is found in every face that it reaches into, even
/// if it owns none of the corners. \throw InvalidInput for no site or one that is not on the mesh, Cancelled.
/// Complexity: a field for each site, bounded by the greatest distance of a vertex from its site.
VoronoiRegions voronoi_regions(FieldTeam& team, const PointList& sites, const Progress& progress = {});

}  // namespace vorogeo
