// Curves that filters take: the lines of another layer, or selected edges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "exact/exact_solver.h"
#include "host/filter_row.h"
#include "layers/layer_surface.h"
#include "layers/points.h"
#include "tasks/workers.h"

namespace vorogeo::plugin {

/// The ends of the selected edges of the surface, as core vertices; each edge once. \throw InvalidInput if
/// there is none, in a sentence that ends with `otherwise`: what to do instead.
std::vector<std::array<Index, 2>> selected_edges(const FilterCall& call, const LayerSurface& layer,
                                                 const Mesh& mesh, const std::string& otherwise);

/// The parameter spacing, and its value: where it is 0, a quarter of the typical edge.
RichLength spacing_parameter(const MeshDocument& document);
double spacing_of(const FilterCall& call, const Mesh& mesh);

/// Points of a layer and along its lines, moved to the surface.
struct CurveSources {
  std::vector<ExactSource> sources;
  std::vector<Index> numbers;  ///< of each: the nearest vertex of the layer
  double snap_distance = 0.0;  ///< the farthest move
};

/// The vertices of the layer that a parameter names, and points at most `spacing` apart along its edges, with
/// the quality of its vertices as offsets or none. Reads max_snap_distance. \throw InvalidInput as
/// other_layer and PointSnapper, and for a layer without vertices.
CurveSources sources_of_layer(const FilterCall& call, LayerSurface& layer, const char* parameter,
                              double spacing, bool with_offsets);

/// The parameters curve_layer, with this help, and max_snap_distance.
RichParameterList curve_layer_parameters(const MeshDocument& document, const char* help);
/// The parameters curve_layer and max_snap_distance.
RichParameterList curve_parameters(const MeshDocument& document);
/// Whether curve_layer is the current layer.
bool curve_is_selected(const FilterCall& call);
/// Explains these parameters, for the help.
QString help_on_curve();

/// The lines of curve_layer, which is not the current one, as the ends of their legs. They may branch and be
/// in several parts. Of a layer without lines, its vertices in their order.
struct CurveLegs {
  std::vector<SurfacePoint> from, to;
  std::vector<std::array<Index, 2>> numbers;  ///< of the ends in their layer
  double snap_distance = 0.0;                 ///< the farthest move
};
/// \throw InvalidInput as other_layer and PointSnapper, and for lines without length.
CurveLegs legs_of_curve(const FilterCall& call, LayerSurface& layer);
/// Points at most `spacing` apart along the shortest paths that join the ends of the legs. \throw
/// InvalidInput for a leg without a path (names its ends).
std::vector<SurfacePoint> points_along(Surface& surface, const CurveLegs& legs, double spacing,
                                       const TaskOptions& options);

/// The edges of the surface that are selected, where curve_layer is the current one. \throw InvalidInput if
/// none is.
std::vector<std::array<Index, 2>> selected_curve(const FilterCall& call, const LayerSurface& layer,
                                                 const Mesh& mesh);

/// The points of each curve in order: of an open one from end to end, of a closed one from one point round to
/// it, of a layer without edges in the order of its vertices. \throw InvalidInput also for one that branches.
std::vector<TaskPoints> curves_in_order(const FilterCall& call, LayerSurface& layer);
/// The same of one curve. \throw InvalidInput also where there are several.
TaskPoints curve_in_order(const FilterCall& call, LayerSurface& layer);

/// The points of a curve, joined by shortest paths and closed: each shares a face with the next.
std::vector<SurfacePoint> closed_line(Surface& surface, const TaskPoints& curve, const TaskOptions& options);

/// The parameters curve_layer and max_snap_distance of filters about a region.
RichParameterList region_parameters(const MeshDocument& document);
/// By face of the layer's surface, whether it is selected. \throw InvalidInput if none is.
std::vector<std::uint8_t> selected_region(const FilterCall& call, const LayerSurface& layer);

}  // namespace vorogeo::plugin
