// The source of a filter that takes only one: a vertex by number, a point of the surface, or the vertex
// nearest to a point.
#pragma once

#include <limits>
#include <memory>

#include "host/filter_row.h"
#include "layers/layer_mesh.h"
#include "mesh/surface_point.h"

namespace vorogeo::plugin {

/// A vertex and its distance from the point for which it was found; 0 if it was named by number.
struct StartVertex {
  Index vertex = no_index;
  double distance = std::numeric_limits<double>::infinity();
};

/// A point of the surface and its distance from the point in space for which it was found; 0 if it was named
/// by number.
struct StartPoint {
  SurfacePoint point;
  double distance = 0.0;
};

/// The parameters start_point (a point picker in the window) and vertex_index. `where`: ends the sentence
/// "Where distances start: ..." about the point.
void add_start_vertex_parameters(RichParameterList& list, const MeshDocument& document, const QString& where);

/// The start vertex named by number, otherwise the point of the surface nearest to the start point: a vertex
/// if it is one up to single precision. Logs which. \throw as start_vertex.
StartPoint start_point(const FilterCall& call, const LayerMesh& layer_mesh,
                       const std::shared_ptr<const Mesh>& mesh);

/// The start vertex named by number, otherwise the one nearest to the start point that has a face; logs
/// which. \throw InvalidInput for a number without a vertex and a point that is not finite.
StartVertex start_vertex(const FilterCall& call, const LayerMesh& layer_mesh);

}  // namespace vorogeo::plugin
