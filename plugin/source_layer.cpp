// Reads source_layer and max_snap_distance.
#include "source_layer.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "support/error.h"

namespace vorogeo::plugin {

void add_source_layer_parameters(RichParameterList& list, const char* what) {
  list.addParam(
      RichInt("source_layer", 0, "Source layer", QString("Number of the layer with the %1.").arg(what)));
  list.addParam(RichFloat("max_snap_distance", 0, "Max snap distance",
                          "How far a point may be from the surface; 0: any distance."));
}

const MeshModel& source_layer(const FilterCall& call, const char* what) {
  const int id = call.parameters.getInt("source_layer");
  const MeshModel* other = call.document.getMesh(id);
  if (other == nullptr || other == &call.layer) {
    throw InvalidInput("source_layer is " + std::to_string(id) +
                       (other == nullptr ? ", but there is no such layer." : ", the current layer itself.") +
                       " Give the number of the layer with the " + what + ".");
  }
  return *other;
}

Point position_of(const CVertexO& vertex) {
  return {double(vertex.cP()[0]), double(vertex.cP()[1]), double(vertex.cP()[2])};
}

PointSnapper::PointSnapper(const FilterCall& call, std::shared_ptr<const Mesh> mesh)
    : locator_(std::move(mesh)),
      layer_(call.parameters.getInt("source_layer")),
      most_(call.parameters.getFloat("max_snap_distance")) {}

SurfacePoint PointSnapper::snap(const Point& at, std::size_t number) {
  const SnappedPoint found = locator_.nearest(at);
  if (most_ > 0.0 && found.distance > most_) {
    std::ostringstream text;
    text << "Vertex " << number << " of layer " << layer_ << " is " << found.distance
         << " away from the surface, more than max_snap_distance " << most_
         << ". Move it or raise the limit.";
    throw InvalidInput(text.str());
  }
  farthest_ = std::max(farthest_, found.distance);
  return found.point;
}

}  // namespace vorogeo::plugin
