// Reads layers of points and max_snap_distance.
#include "layers/source_layer.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "layers/parameters.h"

namespace vorogeo::plugin {

namespace {

/// A layer besides the current one, if there is one.
unsigned int some_other_layer(const MeshDocument& document) {
  for (const MeshModel& layer : document.meshIterator()) {
    if (&layer != document.mm()) return static_cast<unsigned int>(layer.id());
  }
  return static_cast<unsigned int>(document.mm()->id());
}

}  // namespace

void add_source_layer_parameters(RichParameterList& list, const MeshDocument& document, const char* what) {
  list.addParam(RichMesh("source_layer", some_other_layer(document), &document, "Source layer",
                         QString("The layer with the %1.").arg(what)));
  list.addParam(max_snap_distance_parameter(document));
}

const MeshModel& other_layer(const FilterCall& call, const char* parameter, const char* what) {
  const auto id = static_cast<int>(call.parameters.getMeshId(parameter));
  const MeshModel* other = call.document.getMesh(id);
  if (other == nullptr || other == &call.layer) {
    refuse(call, parameter, id,
           std::string(other == nullptr ? ", but there is no such layer." : ", the current layer itself.") +
               " Choose the layer with the " + what + ".");
  }
  return *other;
}

Point position_of(const CVertexO& vertex) {
  return {double(vertex.cP()[0]), double(vertex.cP()[1]), double(vertex.cP()[2])};
}

PointSnapper::PointSnapper(const FilterCall& call, std::shared_ptr<const Mesh> mesh, const char* parameter)
    : locator_(std::move(mesh)),
      call_(call),
      parameter_(parameter),
      max_distance_(length_of(call, "max_snap_distance", true)) {}

SurfacePoint PointSnapper::snap(const Point& at, std::size_t number) {
  const SnappedPoint found = locator_.nearest(at);
  if (max_distance_ > 0.0 && found.distance > max_distance_) {
    std::ostringstream text;
    text << "Vertex " << number << " of layer " << call_.parameters.getMeshId(parameter_) << " is "
         << found.distance << " away from the surface, more than " << named(call_, "max_snap_distance")
         << ", " << max_distance_ << ". Move it or raise the limit.";
    throw InvalidInput(text.str());
  }
  farthest_ = std::max(farthest_, found.distance);
  return found.point;
}

SnappedLayer snapped_layer(const FilterCall& call, std::shared_ptr<const Mesh> mesh, const char* parameter,
                           const char* what) {
  const CMeshO& layer = other_layer(call, parameter, what).cm;
  PointSnapper snapper(call, std::move(mesh), parameter);
  SnappedLayer result;
  for (std::size_t v = 0; v < layer.vert.size(); ++v) {
    if (layer.vert[v].IsD()) continue;
    result.points.push_back(snapper.snap(position_of(layer.vert[v]), v));
    result.numbers.push_back(static_cast<int>(v));
  }
  result.snap_distance = snapper.farthest();
  if (result.points.empty()) {
    throw InvalidInput("Layer " + std::to_string(call.parameters.getMeshId(parameter)) +
                       " has no vertex. Choose a layer with " + what + ".");
  }
  return result;
}

}  // namespace vorogeo::plugin
