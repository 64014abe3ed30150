// Filters for two points: their distance, and the shortest path as a layer.
#include <cmath>
#include <iomanip>
#include <sstream>

#include "filters/rows.h"
#include "host/ticking.h"
#include "layers/answering.h"
#include "layers/path_lines.h"
#include "layers/points.h"
#include "layers/results.h"

namespace vorogeo::plugin {

// ---- Filter: the distance of two points

namespace {

RichParameterList two_points_parameters(const MeshDocument& document) {
  return list_of(end_point_parameters(document, 0), method_parameter());
}

std::string name_of(const LayerSurface& layer, const Mesh& mesh, const SurfacePoint& point) {
  const HostPlace place = layer.host_place(mesh, point);
  return place.face < 0 ? "Vertex " + std::to_string(place.vertex)
                        : "Point in face " + std::to_string(place.face);
}

Results distance_between_points(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const EndPoints ends = end_points(call, *layer);
  const auto& [source, target] = ends;
  const AnswerMethod method = method_of(call);
  const auto ask = [&](Surface& surface, Answered& answered, const Progress& progress) {
    return surface.distance(source.point, target.point, method, answered, progress);
  };
  auto answer = ask_surface(call, *layer, "Geodesic distance", ask);
  const double distance = answer.found;
  rest_if_large(*layer, answer.answered, mesh->vertex_count());
  std::ostringstream text;
  text << name_of(*layer, *mesh, source.point) << " to " << name_of(*layer, *mesh, target.point) << ": ";
  if (std::isfinite(distance)) {
    text << "distance " << logged_length(distance) << ", in " << std::setprecision(3)
         << answer.answered.seconds << " s";
  } else {
    text << "no path, they lie in different components";
  }
  call.log(text.str());
  Results results = {{"distance", distance}, {"seconds", answer.answered.seconds}};
  results.merge(about_end_points(ends));
  results.merge(answer.about);
  return results;
}

// ---- Filter: the shortest path between two points as a polyline layer

RichParameterList path_parameters(const MeshDocument& document) {
  return list_of(
      end_point_parameters(document, -1), method_parameter(),
      RichBool("exact", false, "Exact", "The exact shortest path instead of the refined one; slower."),
      RichBool("certify", true, "Certify",
               "With exact: prove that no path is shorter. Unticked, the search is narrower, "
               "within bounds from the index that are not proven."));
}

Results draw_path(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const EndPoints ends = end_points(call, *layer);
  const auto& [source, target] = ends;
  const bool exact = call.parameters.getBool("exact");
  const bool certify = call.parameters.getBool("certify");
  const AnswerMethod method = method_of(call);
  const auto ask = [&](Surface& surface, Answered& answered, const Progress& progress) {
    return surface.path(source.point, target.point, method, {exact, certify}, answered, progress);
  };
  auto answer = ask_surface(call, *layer, "Shortest path", ask);
  const ExactPath& result = answer.found;
  rest_if_large(*layer, answer.answered, mesh->vertex_count());
  call.progress.report(1.0, "Shortest path");
  const PathLines polyline = lines_of(*mesh, result.path);
  const std::vector<bool> over_gap = steps_over_gaps(*mesh, result.path.points);
  double gap_length = 0.0;
  std::vector<std::size_t> marked;
  for (std::size_t i = 0; i < over_gap.size(); ++i) {
    if (!over_gap[i]) continue;
    gap_length += polyline.along[i + 1] - polyline.along[i];
    marked.push_back(i);
  }
  std::ostringstream text;
  if (polyline.lines.points.empty()) {
    text << "No path: the points lie in different components";
  } else {
    add_polyline_layer(call.document, call.layer, "Geodesic path", polyline.lines, polyline.along, true);
    text << "Path of length " << logged_length(result.path.length) << " over " << polyline.lines.points.size()
         << " points";
    if (!marked.empty()) {
      text << "; " << marked.size() << " of its steps run over gaps, a length of "
           << logged_length(gap_length) << ", from selected vertices";
      for (const std::size_t point : marked) call.document.mm()->cm.vert[point].SetS();
    }
  }
  call.log(text.str());
  Results results = {{"length", result.path.length},
                     {"certified", result.certified},
                     {"points", static_cast<int>(polyline.lines.points.size())},
                     {"steps_over_gaps", static_cast<int>(marked.size())},
                     {"gap_length", gap_length},
                     {"seconds", answer.answered.seconds}};
  results.merge(about_end_points(ends));
  results.merge(answer.about);
  return results;
}

}  // namespace

std::vector<FilterRow> path_rows() {
  return {
      {"Geodesic distance between two points (VoroGeo)", "get_vorogeo_distance_between_points",
       "<p>Geodesic distance of two points: the length of the shortest path over the surface, in the unit of "
       "the mesh. It is logged and returned as <i>distance</i>; infinity if no path leads from one to the "
       "other. Without an index it is exact. With one it comes from the index for two vertices, and is the "
       "length of the refined path for other points. The mesh is not changed.</p><p>How to choose: for the "
       "path itself take <i>Shortest path between two points (VoroGeo)</i>.</p>" +
           help_on_end_points() + help_on_choosing() + references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, two_points_parameters, distance_between_points},
      {"Shortest path between two points (VoroGeo)", "generate_polyline_by_vorogeo_geodesic_path",
       "<p>The shortest path over the surface between two points, as a new polyline layer, which becomes the "
       "current one; the quality of its vertices is the length up to there. Vertices from which a step runs "
       "over a bridged gap are selected.</p>" +
           help_on_end_points() +
           "<p>Without an index, the path is always the exact one. With an index it is refined: the route of "
           "the index, shortened until it is a geodesic, which is mostly the shortest path itself. With "
           "<b>Exact</b> it is the shortest path, found in milliseconds by propagation in a corridor; "
           "<b>Certify</b> proves it without relying on the index.</p><p>Returns the <i>length</i>, infinity "
           "and no layer if the points lie in different components, the number of <i>points</i> and whether "
           "it is <i>certified</i>.</p>" +
           help_on_choosing() + references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, path_parameters, draw_path}};
}

}  // namespace vorogeo::plugin
