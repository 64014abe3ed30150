// The two points of a filter for one pair.
#pragma once

#include <memory>

#include "host/filter_row.h"
#include "layers/layer_mesh.h"
#include "mesh/surface_locator.h"

namespace vorogeo::plugin {

/// Two points of the surface; `distance` is how far each was moved there.
struct EndPoints {
  SnappedPoint source;
  SnappedPoint target;
};

/// The parameters source and target (vertices by number), source_point and target_point (in space),
/// max_snap_distance, and surface_points (both as text). `vertex`: what source and target are by default.
void add_end_point_parameters(RichParameterList& list, const MeshDocument& document, int vertex);

/// The points that these parameters give. \throw InvalidInput for a point that does not exist or is too far
/// from the surface.
EndPoints end_points(const FilterCall& call, const LayerMesh& layer_mesh,
                     const std::shared_ptr<const Mesh>& mesh);

/// How far the points were moved to the surface, as returned values.
Results about_end_points(const EndPoints& ends);

/// Explains source and target, for the help.
QString help_on_end_points();

}  // namespace vorogeo::plugin
