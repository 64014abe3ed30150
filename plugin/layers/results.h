// What filters leave behind: distances as vertex quality, and new layers.
#pragma once

#include <span>
#include <vector>

#include "exact/exact_solver.h"
#include "host/filter_row.h"
#include "layers/answering.h"
#include "layers/layer_surface.h"
#include "mesh/surface_point.h"
#include "tasks/surface_lines.h"

namespace vorogeo::plugin {

// ---- From source vertices to the quality and the colours of the layer: what all distance filters share

/// Quality of a vertex that got no distance: no path leads to it, or it lies beyond max_distance. A number
/// below every distance and finite, so that it can be told from a source and does not spoil ramps and
/// histograms.
inline constexpr double quality_without_distance = -1.0;

/// Along the host's ramp from red to blue; light grey, which is not on it, without a distance.
vcg::Color4b color_of_distance(double distance, double largest);

/// Distances, one for each core vertex, as quality and colours. `host_vertices`: their numbers in the layer.
void write_distances(MeshModel& layer, std::span<const Index> host_vertices,
                     std::span<const double> distances, double largest);

/// The parameter max_distance, as all distance filters have it.
RichLength max_distance_parameter(const MeshDocument& document);
/// The parameters of exact filters that have no others.
RichParameterList only_max_distance(const MeshDocument& document);
/// Adds method and max_distance.
void add_field_parameters(RichParameterList& list, const MeshDocument& document);

/// Writes the distances from the nearest source vertex into the quality of all vertices, and colours along a
/// ramp. Reads max_distance. Nothing is changed before everything is computed.
///
/// Returns source_vertices, reached_vertices, unreachable_vertices, vertices_beyond_max_distance,
/// max_distance (the largest distance found), seconds (of the distances alone), and what
/// about_answer() does.
Results write_distance_field(FilterCall& call, LayerSurface& layer, const std::vector<Index>& sources,
                             AnswerMethod method);

/// The same for points anywhere on the surface, each with an offset; returns
/// source_points instead of source_vertices. If there are `numbers`, one for each source, the vertices also
/// get that of their nearest source as the custom attribute nearest_source, -1 where there is none.
Results write_distance_field(FilterCall& call, LayerSurface& layer, const std::vector<ExactSource>& sources,
                             const std::vector<Index>* numbers, AnswerMethod method);

// ---- Layers that filters add to the document: points and polylines on the surface of the current layer

/// Adds a layer with these points as vertices, with `quality` (as many values, or none). It has the transform
/// of the current layer, so that it lies on it. `make_current`: as the host does for filters that generate.
void add_point_layer(FilterCall& call, const QString& name, const std::vector<Point>& points,
                     std::span<const double> quality, bool make_current);

/// Adds a layer with vertices and edges, with the transform of the layer `on` which they lie.
void add_polyline_layer(MeshDocument& document, const MeshModel& on, const QString& name,
                        const SurfaceLines& lines, std::span<const double> quality, bool make_current);

/// Points of the surface as a layer, which becomes current. \return the numbers of their vertices in the
/// host, -1 for a point that is not a vertex, as Eigen::VectorXd.
QVariant add_surface_point_layer(FilterCall& call, const QString& name, const LayerSurface& layer,
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
