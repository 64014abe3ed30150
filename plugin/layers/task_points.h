// The points that a task is about: selected vertices, the points of a layer, or surface points in a text.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/filter_row.h"
#include "layers/layer_mesh.h"
#include "mesh/surface_point.h"

namespace vorogeo::plugin {

/// The points, and what errors, logs and results call them.
struct TaskPoints {
  PointList points;
  /// The number of each point: that of its vertex in the current layer (selection) or in the layer that it
  /// comes from, or its position in the text.
  std::vector<int> numbers;
  std::string what;            ///< such as "selected vertices"
  double snap_distance = 0.0;  ///< the farthest move of a layer's point

  std::size_t size() const { return points.size(); }
};

/// The parameters point_layer and surface_points; max_snap_distance belongs to them and is also added unless
/// the filter has it anyway. `what`: ends the sentence "The layer with the ...".
void add_task_point_parameters(RichParameterList& list, const MeshDocument& document, const char* what,
                               bool with_snap_distance = true);

/// The points that these parameters give. `purpose`: as for selected_vertices. \throw InvalidInput if there
/// is no point, or one that is not on the surface or too far from it.
TaskPoints task_points(const FilterCall& call, const LayerMesh& layer_mesh, const char* purpose);

/// Surface points written as text, separated by semicolons: a vertex as its number, any other point as the
/// number of a face and three weights. All numbers are the host's. \throw InvalidInput that names the
/// parameter and the entry.
std::vector<SurfacePoint> parse_surface_points(const FilterCall& call, const LayerMesh& layer_mesh,
                                               const Mesh& mesh, const char* parameter);

}  // namespace vorogeo::plugin
