// Geodesic Voronoi regions of chosen points: labels, areas, and borders that cross the faces.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "query/field_team.h"
#include "query/surface_lines.h"
#include "support/progress.h"

namespace vorogeo {

/// Regions are positions in the list of sites; no_index where no site can be reached.
struct VoronoiRegions {
  std::vector<Index> vertex_region;  ///< of the nearest site, of equally near ones the first
  std::vector<double> distance;      ///< of each vertex from it
  std::vector<Index> face_region;    ///< the region at the face's centre
  std::vector<double> area;          ///< of each region, in the square of the mesh's unit
  SurfaceLines borders;
  /// The two regions at each segment of the borders, the smaller one first.
  std::vector<std::array<Index, 2>> border_regions;
};

/// Regions of the sites by the fields of `team`. A site that repeats an earlier one owns nothing.
///
/// In a face, the difference of the squares of two distances is interpolated linearly between the corners: on
/// flat parts of the surface that is what it is, and borders there are exact. Each region is then where its
/// square is the least, so borders continue over edges, and three or more may meet in a face. A region is
/// found in every face that it reaches into, also between the corners.
/// \throw InvalidInput for no site or one that is not on the mesh, Cancelled.
/// Complexity: a field for each site, bounded by the greatest distance of a vertex from its site.
VoronoiRegions voronoi_regions(FieldTeam& team, const PointList& sites, const Progress& progress = {});

}  // namespace vorogeo
