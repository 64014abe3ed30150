// The end points of a path as the index sees them.
#pragma once

#include <vector>

#include "index/index_data.h"
#include "mesh/surface_point.h"
#include "route/graph_route.h"

namespace vorogeo {

/// An end point in the work mesh.
struct PathEnd {
  SurfacePoint point;
  SurfacePoint user;        ///< the same in the user's mesh
  Index vertex = no_index;  ///< the point itself or the nearest corner of its face
  double to_vertex = 0.0;   ///< distance of the point from that vertex
  std::vector<Index> patches;

  /// Second-layer patch of an end in a face; no_index for a vertex.
  Index patch(const IndexData& data) const {
    return point.is_vertex() ? no_index : data.work.second_layer[point.face];
  }
};

/// The end at a point of the user's mesh.
PathEnd path_end(const IndexData& data, const SurfacePoint& user);

/// Whether a second-layer patch of one end is or touches one of the other.
bool are_near(const IndexData& data, const PathEnd& a, const PathEnd& b);

/// The border nodes of the end's patch with their distances from it.
RouteEnd route_end_of(const IndexData& data, const PathEnd& end);

}  // namespace vorogeo
