// Reads source, target, source_point, target_point and surface_points.
#include "layers/end_points.h"

#include <sstream>

#include "layers/parameters.h"
#include "layers/task_points.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

/// A vertex by its number, else the surface point nearest to a position.
SnappedPoint end_of(const FilterCall& call, const LayerMesh& layer_mesh,
                    const std::shared_ptr<const Mesh>& mesh, const char* vertex, const char* point) {
  const int number = call.parameters.getInt(vertex);
  if (number != -1) return {SurfacePoint::at_vertex(vertex_of(call, layer_mesh, vertex)), 0.0};
  const SnappedPoint found = SurfaceLocator(mesh).nearest(point_of(call, point));
  const double max_distance = length_of(call, "max_snap_distance", true);
  if (max_distance > 0.0 && found.distance > max_distance) {
    std::ostringstream text;
    text << named(call, point) << " is " << found.distance << " away from the surface, more than "
         << named(call, "max_snap_distance") << ", " << max_distance
         << ". Move the point or raise the limit.";
    throw InvalidInput(text.str());
  }
  return found;
}

}  // namespace

void add_end_point_parameters(RichParameterList& list, const MeshDocument& document, int vertex) {
  list.addParam(
      RichInt("source", vertex, "Source vertex", "Number of the first vertex, counted from 0; -1: a point."));
  list.addParam(RichInt("target", vertex, "Target vertex",
                        "Number of the second vertex, counted from 0; -1: a point."));
  list.addParam(RichPosition("source_point", document.mm()->cm.bbox.min, "Source point",
                             "Used if the source vertex is -1: the nearest point of the surface. Choose "
                             "'Surf. Pos.' and press Get, then double-click on the surface."));
  list.addParam(RichPosition("target_point", document.mm()->cm.bbox.max, "Target point",
                             "Used if the target vertex is -1: the nearest point of the surface."));
  list.addParam(max_snap_distance_parameter(document));
  list.addParam(RichString("surface_points", "", "Surface points",
                           "Used instead of all these if not empty: source and target, each the number of a "
                           "vertex, or of a face with three weights, such as 17; 203 0.2 0.3 0.5."));
}

EndPoints end_points(const FilterCall& call, const LayerMesh& layer_mesh,
                     const std::shared_ptr<const Mesh>& mesh) {
  const auto written = parse_surface_points(call, layer_mesh, *mesh, "surface_points");
  if (written.size() == 2) return {{written[0], 0.0}, {written[1], 0.0}};
  if (!written.empty()) {
    throw InvalidInput(named(call, "surface_points") + " holds " + std::to_string(written.size()) +
                       " points. Give two, the source and the target, separated by a semicolon.");
  }
  return {end_of(call, layer_mesh, mesh, "source", "source_point"),
          end_of(call, layer_mesh, mesh, "target", "target_point")};
}

Results about_end_points(const EndPoints& ends) {
  return {{"source_snap_distance", ends.source.distance}, {"target_snap_distance", ends.target.distance}};
}

QString help_on_end_points() {
  return "<p>A point is a vertex, given by its number in <b>Source vertex</b> or <b>Target vertex</b>, or, "
         "if that is -1, the point of the surface nearest to <b>Source point</b> or <b>Target point</b>; "
         "<i>source_snap_distance</i> and <i>target_snap_distance</i> say how far it was moved. <b>Surface "
         "points</b> gives both exactly, such as <tt>17; 203 0.2 0.3 0.5</tt>: a vertex by its number, any "
         "other point by the number of a face and three barycentric weights.</p>";
}

}  // namespace vorogeo::plugin
