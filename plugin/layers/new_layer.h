// Layers that filters add to the document: points and polylines on the surface of the current layer.
#pragma once

#include <span>
#include <vector>

#include "host/filter_row.h"
#include "layers/layer_mesh.h"
#include "mesh/surface_point.h"
#include "tasks/surface_lines.h"

namespace vorogeo::plugin {

/// Adds a layer with these points as vertices, with `quality` (as many values, or none). It has the transform
/// of the current layer, so that it lies on it. `make_current`: as the host does for filters that generate.
void add_point_layer(FilterCall& call, const QString& name, const std::vector<Point>& points,
                     std::span<const double> quality, bool make_current);

/// Adds a layer with vertices and edges, with the transform of the layer `on` which they lie.
void add_polyline_layer(MeshDocument& document, const MeshModel& on, const QString& name,
                        const SurfaceLines& lines, std::span<const double> quality, bool make_current);

/// Points of the surface as a layer, which becomes current. \return the numbers of their vertices in the
/// host, -1 for a point that is not a vertex, as Eigen::VectorXd.
QVariant add_surface_point_layer(FilterCall& call, const QString& name, const LayerMesh& layer_mesh,
                                 const Mesh& mesh, const PointList& points);

/// Numbers in the form in which the host passes them to Python.
template <class Values>
QVariant as_vector(const Values& values) {
  Eigen::VectorXd vector(static_cast<Eigen::Index>(values.size()));
  Eigen::Index at = 0;
  for (const auto& value : values) vector[at++] = static_cast<double>(value);
  return QVariant::fromValue(vector);
}

}  // namespace vorogeo::plugin
