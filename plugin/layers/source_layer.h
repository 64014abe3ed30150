// A layer from which a filter takes points: its parameter, and its points moved to the surface.
#pragma once

#include <memory>
#include <vector>

#include "host/filter_row.h"
#include "mesh/surface_locator.h"

namespace vorogeo::plugin {

/// The parameters source_layer and max_snap_distance. `what`: "points", or "points or lines".
void add_source_layer_parameters(RichParameterList& list, const MeshDocument& document, const char* what);

/// The layer named by a parameter. \throw InvalidInput if there is none, or if it is the current one.
const MeshModel& other_layer(const FilterCall& call, const char* parameter, const char* what);

Point position_of(const CVertexO& vertex);

/// Moves points to the surface, within max_snap_distance.
class PointSnapper {
 public:
  /// `parameter`: the one that names the layer of the points.
  PointSnapper(const FilterCall& call, std::shared_ptr<const Mesh> mesh, const char* parameter);
  /// `number`: that of the vertex in the layer, for the error. \throw InvalidInput if it is too far away.
  SurfacePoint snap(const Point& at, std::size_t number);
  /// The farthest move so far.
  double farthest() const { return farthest_; }

 private:
  SurfaceLocator locator_;
  const FilterCall& call_;
  const char* parameter_;
  double max_distance_;
  double farthest_ = 0.0;
};

/// All vertices of a layer, moved to the surface.
struct SnappedLayer {
  std::vector<SurfacePoint> points;
  std::vector<int> numbers;  ///< of the vertices in their layer
  double snap_distance = 0.0;
};

/// \throw InvalidInput as other_layer and PointSnapper, and for a layer without vertices.
SnappedLayer snapped_layer(const FilterCall& call, std::shared_ptr<const Mesh> mesh, const char* parameter,
                           const char* what);

}  // namespace vorogeo::plugin
