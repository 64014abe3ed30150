// Filters that write a distance field: from a point, the selection, the border, a layer or edges, on both
// sides of a curve or a region; and the directions of paths from a point.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "filters/rows.h"
#include "layers/answering.h"
#include "layers/curves.h"
#include "layers/layer_metric.h"
#include "layers/points.h"
#include "layers/results.h"
#include "support/error.h"
#include "tasks/curve_sources.h"
#include "tasks/directions.h"
#include "tasks/signed_distance.h"

namespace vorogeo::plugin {

// ---- The field: asked for, written as quality and colours, and logged

namespace {

RichParameterList field_parameters(const MeshDocument& document) {
  return list_of(
      length_parameter(
          document, "max_distance", 0.0, "Max distance (0: no limit)",
          "Distances above this length are not computed: those vertices get quality -1. In the unit of the "
          "mesh, or in percent of the diagonal of its bounding box."),
      direction_parameter());
}

RichParameterList method_and_max_distance(const MeshDocument& document) {
  return list_of(method_parameter(), field_parameters(document));
}

/// The limit to compute with: `unreachable` stands for none.
double max_distance_of(const FilterCall& call) {
  const double value =
      checked_value(call, "max_distance", call.parameters.getAbsPerc("max_distance"), Values::from_0,
                    ". Give a positive length in the unit of the mesh, or 0 for no limit.");
  return value == 0.0 ? unreachable : value;
}

/// How many vertices got a distance, and why the others did not.
struct Reach {
  int reached = 0;
  int no_path = 0;
  int beyond = 0;  ///< farther than the max distance
  double largest = 0.0;
};

Reach reach_of(const Mesh& mesh, const std::vector<ExactSource>& sources,
               const std::vector<double>& distances) {
  std::vector<bool> has_source(static_cast<std::size_t>(mesh.component_count()), false);
  for (const ExactSource& source : sources) has_source[component_of(mesh, source.point)] = true;
  Reach reach;
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
    if (std::isfinite(distances[v])) {
      ++reach.reached;
      reach.largest = std::max(reach.largest, distances[v]);
    } else {
      ++(has_source[mesh.component(v)] ? reach.beyond : reach.no_path);
    }
  }
  return reach;
}

/// Logs why vertices got no distance; `limit`: what they may lie beyond. \return reached_vertices,
/// unreachable_vertices, vertices_beyond_max_distance, and max_distance, the largest distance found.
Results about_reach(const FilterCall& call, const Reach& reach, const char* limit) {
  if (reach.no_path > 0) {
    call.log("No path leads to " + std::to_string(reach.no_path) +
             " vertices, in other components than the sources; their quality is -1 and their colour grey");
  }
  if (reach.beyond > 0) {
    call.log(std::to_string(reach.beyond) + " vertices lie beyond the " + limit +
             "; their quality is -1 and their colour grey");
  }
  return {{"reached_vertices", reach.reached},
          {"unreachable_vertices", reach.no_path},
          {"vertices_beyond_max_distance", reach.beyond},
          {"max_distance", reach.largest}};
}

/// Writes the distances from the nearest source into the quality of all vertices, and colours along a ramp.
/// Reads max_distance. Nothing is changed before everything is computed. `numbers`: one for each source; the
/// vertices get that of their nearest source as the custom attribute nearest_source, -1 where there is none.
///
/// Returns source_points where there are numbers, otherwise source_vertices (0 for a point in a face);
/// seconds (of the distances alone); and what about_reach() and about_answer() return.
Results write_distance_field(FilterCall& call, LayerSurface& layer, const std::vector<ExactSource>& sources,
                             Answer method, const std::vector<Index>& numbers = {}) {
  const double limit = max_distance_of(call);
  const auto mesh = layer.mesh();
  const auto ask = [&](Surface& surface, Answered& by, const Progress& progress) {
    return surface.field(sources, limit, method, by, progress);
  };
  auto [field, answered, results] = ask_surface(call, layer, "Geodesic distances", ask);
  field.distance.resize(mesh->given_vertex_count());
  const Reach reach = reach_of(*mesh, sources, field.distance);
  rest_if_large(layer, answered, reach.reached);
  call.progress.report(1.0, "Writing quality and colours");

  write_distances(call.layer, layer.arrays().input_of_vertex, field.distance, reach.largest);
  if (!numbers.empty()) {
    auto label = vcg::tri::Allocator<CMeshO>::GetPerVertexAttribute<Scalarm>(call.layer.cm, "nearest_source");
    for (Index v = 0; v < mesh->given_vertex_count(); ++v) {
      const Index nearest = field.source[v];
      label[call.layer.cm.vert[layer.host_vertex(v)]] =
          static_cast<Scalarm>(nearest == no_index ? no_index : numbers[nearest]);
    }
  }

  const bool at_vertices = numbers.empty() && layer.host_place(*mesh, sources[0].point).face < 0;
  const char* kind = at_vertices ? (sources.size() == 1 ? " source vertex" : " source vertices")
                                 : (sources.size() == 1 ? " source point" : " source points");
  std::ostringstream text;
  const bool to = asks_for_paths_to(call);
  text << (to ? "Distances to " : "Distances from ") << sources.size() << kind << (to ? " from " : " to ")
       << reach.reached << " vertices, the largest " << logged_length(reach.largest) << ", in "
       << std::setprecision(3) << answered.seconds << " s";
  call.log(text.str());
  if (answered.expected_error > 0.0) {
    std::ostringstream error;
    const bool is_exact = answered.by == Answer::exact;
    error << "Error of the distances, in the mean: " << (is_exact ? "about " : "usually below ")
          << std::setprecision(2) << 100.0 * answered.expected_error << " %, "
          << (is_exact ? "estimated for this metric" : "as measured on many meshes");
    call.log(error.str());
  }
  results.merge(about_reach(call, reach, "max distance"));
  const int count = numbers.empty() && !at_vertices ? 0 : static_cast<int>(sources.size());
  results[numbers.empty() ? "source_vertices" : "source_points"] = count;
  results["seconds"] = answered.seconds;
  return results;
}

// ---- The rows of all these filters

QString help_on_field() {
  return "<p>The distance becomes the vertex quality, in the unit of the mesh, and a colour: red at the "
         "sources, blue at the farthest vertex. Vertices that no path leads to, or only one longer than "
         "<b>Max distance</b>, get quality <b>-1</b> and grey and are counted in the log. Lengths are those "
         "in the scene: the matrix of the layer is applied.</p>";
}

QString help_on_exact() {
  return "<p>How to choose: exact up to rounding, without an index; one propagation over the whole mesh for "
         "each call, which a <b>Max distance</b> shortens. For many fields on one mesh take the filter "
         "without <i>Exact</i> in its name: from an index they are much faster, with a small error.</p>"
         "<p>See:<br/>" +
         reference_of_exact() +
         "<br/><i>Vitaly Surazhsky, Tatiana Surazhsky, Danil Kirsanov, Steven J. Gortler, Hugues "
         "Hoppe</i><br/><b>\"Fast exact and approximate geodesics on meshes\"</b><br/>ACM Transactions on "
         "Graphics 24(3), 2005.</p>";
}

FilterRow field_row(const char* menu_name, const char* python_name, const QString& help,
                    RichParameterList (*parameters)(const MeshDocument&), Results (*apply)(FilterCall&)) {
  return {menu_name,
          python_name,
          help,
          FilterPlugin::FilterClass(FilterPlugin::VertexColoring | FilterPlugin::Quality),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          parameters,
          apply};
}

// ---- Distance from a given point, from the selection, from the border

constexpr const char* start_meaning = "Where distances start: at the nearest point of the surface";

Results distances_from_point(FilterCall& call, Answer method) {
  const auto layer = layer_of(call);
  const SnappedPoint start = start_point(call, *layer);
  Results results = write_distance_field(call, *layer, {{start.point}}, method);
  results.merge(about_start(*layer, *layer->mesh(), start));
  return results;
}

Results distances_from_selection(FilterCall& call, Answer method) {
  const auto layer = layer_of(call);
  const auto selected = selected_vertices(call, *layer, "where distances shall start");
  return write_distance_field(call, *layer, sources_at(selected), method);
}

QString help_on_start() {
  return "<p>Distances start at the point of the surface nearest to <b>Start point</b>, which need not be a "
         "vertex, or, if its number is given, at <b>Start vertex</b>; the log says where, and how far from "
         "the point.</p>";
}

/// Vertices of edges with one face.
std::vector<Index> border_vertices(const Mesh& mesh) {
  std::vector<Index> border;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_border(v)) border.push_back(v);
  }
  if (border.empty()) {
    throw InvalidInput(
        "The surface has no border: every edge has two faces. Choose another source, for example a "
        "selection.");
  }
  return border;
}

Results distances_from_border(FilterCall& call) {
  const auto layer = layer_of(call);
  return write_distance_field(call, *layer, sources_at(border_vertices(*layer->mesh())), method_of(call));
}

// ---- Distance from the points or lines of another layer, or from edges

RichParameterList from_layer_parameters(const MeshDocument& document) {
  return list_of(source_layer_parameter(document, "points or lines"), max_snap_distance_parameter(document),
                 spacing_parameter(document),
                 RichBool("quality_as_offset", false, "Quality as offset",
                          "Add the quality of a point of the source layer to the distances from it."),
                 method_and_max_distance(document));
}

RichParameterList from_edges_parameters(const MeshDocument& document) {
  return list_of(
      RichBool("from_border", false, "From the border", "All border edges instead of the selected ones."),
      spacing_parameter(document), method_and_max_distance(document));
}

Results distances_from_layer(FilterCall& call) {
  const auto layer = layer_of(call);
  const CurveSources curve = sources_of_layer(call, *layer, "source_layer", spacing_of(call, *layer->mesh()),
                                              call.parameters.getBool("quality_as_offset"));
  Results results = write_distance_field(call, *layer, curve.sources, method_of(call), curve.numbers);
  results["snap_distance"] = curve.snap_distance;
  return results;
}

Results distances_from_edges(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const bool from_border = call.parameters.getBool("from_border");
  std::vector<Index> edges;
  if (from_border) {
    for (Index e = 0; e < mesh->edge_count(); ++e) {
      if (mesh->is_border_edge(e)) edges.push_back(e);
    }
    if (edges.empty()) {
      throw InvalidInput("The surface has no border: every edge has two faces. Select edges instead.");
    }
  } else {
    edges =
        edges_of_curve(*mesh, selected_edges(call, *layer, *mesh, "set " + named(call, "from_border") + "."));
  }
  const auto sources = sources_along_edges(*mesh, edges, spacing_of(call, *mesh));
  std::vector<Index> numbers(sources.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  Results results = write_distance_field(call, *layer, sources, method_of(call), numbers);
  results["source_edges"] = static_cast<int>(edges.size());
  return results;
}

// ---- Distance from a closed curve or the border of a region, by side

Results signed_distances(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const bool of_region = curve_is_selected(call);
  std::vector<std::uint8_t> region;
  std::vector<TaskPoints> curves;
  if (of_region) {
    region = selected_region(call, *layer);
  } else {
    curves = curves_in_order(call, *layer);
  }
  const auto ask = [&](Surface& surface, const TaskOptions& options) {
    if (of_region) return signed_distance(surface, region, unreachable, options);
    std::vector<std::vector<SurfacePoint>> lines;
    const double share = 0.2 / static_cast<double>(curves.size());
    for (const TaskPoints& curve : curves) {
      const double done = share * static_cast<double>(lines.size());
      lines.push_back(closed_line(surface, curve, {options.by, options.progress.part(done, done + share)}));
    }
    return signed_distance(surface, lines, unreachable,
                           {options.by, options.progress.part(0.2, 1.0), options.answered});
  };
  auto [field, answered, results] = ask_task_by(Answer::exact, call, *layer, "Signed distances", ask);
  double inside = 0.0, outside = 0.0;
  int unreached = 0;
  for (Index v = 0; v < mesh->given_vertex_count(); ++v) {
    if (std::isfinite(field[v])) {
      inside = std::min(inside, field[v]);
      outside = std::max(outside, field[v]);
    } else {
      ++unreached;
    }
  }
  call.progress.report(1.0, "Writing quality and colours");

  call.layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
  const double largest = std::max(outside, -inside);
  for (Index v = 0; v < mesh->given_vertex_count(); ++v) {
    CVertexO& vertex = call.layer.cm.vert[layer->host_vertex(v)];
    vertex.Q() = static_cast<Scalarm>(std::isfinite(field[v]) ? field[v] : 0.0);
    vertex.C() = color_of_distance(field[v], largest, -largest);
  }
  std::ostringstream text;
  const std::string from = of_region            ? "the border of the selected faces"
                           : curves.size() == 1 ? "the curve"
                                                : std::to_string(curves.size()) + " curves";
  text << "Signed distances from " << from << ": up to " << logged_length(std::abs(inside)) << " inside and "
       << logged_length(outside) << " outside, in " << std::setprecision(3) << answered.seconds << " s";
  call.log(text.str());
  if (unreached > 0) {
    call.log("No path leads to " + std::to_string(unreached) +
             " vertices, in components without a source; their quality is 0 and their colour grey");
  }
  results["min_distance"] = inside;
  results["max_distance"] = outside;
  results["unreachable_vertices"] = unreached;
  results["snap_distance"] = curves.empty() ? 0.0 : curves[0].snap_distance;
  return results;
}

// ---- Directions from a point

RichParameterList directions_parameters(const MeshDocument& document) {
  return list_of(
      start_parameters(document, "Where paths start: at the nearest point of the surface"),
      length_parameter(document, "radius", 0.1, "Radius (0: no limit)",
                       "Greatest geodesic distance; 0: that of the farthest vertex."),
      RichFloat("rotation", 0, "Rotation", "How far the picture is turned counter-clockwise, in degrees."),
      RichFloat("scale", 1, "Scale", "Width of the picture, in diameters of the disk of the radius."),
      RichInt("rings", 10, "Rings (0: none)",
              "Rings of equal width up to the radius, alternately light and dark."),
      RichBool("per_wedge", false, "Per wedge",
               "Write the texture coordinates of the corners of faces, not of vertices: faces that reach "
               "beyond the radius stay free of the picture."));
}

/// The relative difference between the lengths of edges in the plane of a map and on the surface: the mean,
/// weighted by length, and the largest. Edges with an end that has no distance do not count.
struct Distortion {
  double mean = 0.0;
  double largest = 0.0;
};

Distortion distortion_of(const Mesh& mesh, const LogMap& map) {
  Distortion distortion;
  double total = 0.0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    const double length = mesh.edge_length(e);
    if (!std::isfinite(map.distance[a] + map.distance[b]) || !(length > 0.0)) continue;
    const double in_plane =
        std::hypot(map.vector[b][0] - map.vector[a][0], map.vector[b][1] - map.vector[a][1]);
    total += length;
    distortion.mean += std::abs(in_plane - length);
    distortion.largest = std::max(distortion.largest, std::abs(in_plane - length) / length);
  }
  if (total > 0.0) distortion.mean /= total;
  return distortion;
}

Results directions_from_point(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const double radius = length_of(call, "radius", true);
  const double turn =
      real_of(call, "rotation", Values::all, ". Give a finite number.") * std::numbers::pi / 180.0;
  const double scale = real_of(call, "scale", Values::above_0, ". Give a number above 0.");
  const int rings = number_of(call, "rings", 0, ". Give 0 or a positive number.");
  const bool per_wedge = call.parameters.getBool("per_wedge");
  const SnappedPoint start = start_point(call, *layer);
  const auto ask = [&](Surface& surface, Answered& answered, const Progress& progress) {
    return log_map(surface, start.point, std::nullopt, radius > 0.0 ? radius : unreachable,
                   {Answer::exact, progress, &answered});
  };
  auto answer = ask_surface(call, *layer, "Geodesic directions", ask);
  LogMap& map = answer.found;
  if (layer->placement().is_mirrored()) {  // counter-clockwise as the scene is seen
    for (auto& vector : map.vector) vector[1] = -vector[1];
  }
  const Reach reach = reach_of(*mesh, {{start.point}}, map.distance);
  rest_if_large(*layer, answer.answered, reach.reached);
  call.progress.report(1.0, "Writing texture coordinates, quality and colours");

  const double reached = radius > 0.0 ? radius : reach.largest;
  const double per_width = reached > 0.0 ? 0.5 / (reached * scale) : 0.0;
  const double across = per_width * std::cos(turn);
  const double along = per_width * std::sin(turn);
  const auto is_reached = [&](Index v) { return std::isfinite(map.distance[v]); };
  const auto place = [&](Index v) -> vcg::TexCoord2<float> {
    if (!is_reached(v)) return {0.0F, 0.0F};
    const auto [x, y] = map.vector[v];
    return {static_cast<float>(0.5 + across * x + along * y),
            static_cast<float>(0.5 - along * x + across * y)};
  };
  call.layer.updateDataMask((per_wedge ? MeshModel::MM_WEDGTEXCOORD : MeshModel::MM_VERTTEXCOORD) |
                            MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
  for (Index v = 0; v < mesh->given_vertex_count(); ++v) {
    CVertexO& vertex = call.layer.cm.vert[layer->host_vertex(v)];
    if (!per_wedge) vertex.T() = place(v);
    vertex.Q() = static_cast<Scalarm>(quality_without_distance);
    vertex.C() = grey();
    if (!is_reached(v)) continue;
    const auto [x, y] = map.vector[v];
    const double angle = std::atan2(y, x);
    const double direction = angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
    const double ring =
        reached > 0.0 ? std::min(std::floor(rings * map.distance[v] / reached), rings - 1.0) : 0.0;
    vertex.Q() = static_cast<Scalarm>(direction);
    vertex.C() = color_of_angle(direction, std::fmod(ring, 2.0) == 1.0);
  }
  for (std::size_t f = 0; per_wedge && f < layer->arrays().faces.size(); ++f) {
    const auto& corners = layer->arrays().faces[f];
    const bool is_inside = std::ranges::all_of(corners, is_reached);
    for (int i = 0; i < 3; ++i) {
      call.layer.cm.face[layer->arrays().input_of_face[f]].WT(i) =
          is_inside ? place(corners[i]) : vcg::TexCoord2<float>(0.0F, 0.0F);
    }
  }
  const Distortion distortion = distortion_of(*mesh, map);
  std::ostringstream text;
  text << "Directions of paths to " << reach.reached << " vertices, the farthest "
       << logged_length(reach.largest) << " away, in " << std::setprecision(3) << answer.answered.seconds
       << " s; lengths in the picture differ by " << 100.0 * distortion.mean << " % in the mean, at most by "
       << 100.0 * distortion.largest << " %";
  call.log(text.str());
  Results results = std::move(answer.about);
  results.merge(about_reach(call, reach, "radius"));
  results.merge(about_start(*layer, *mesh, start));
  results["mean_distortion"] = distortion.mean;
  results["max_distortion"] = distortion.largest;
  results["seconds"] = answer.answered.seconds;
  return results;
}

QString help_on_directions() {
  return "<p>The directions in which the shortest paths from a given point to all vertices begin: the "
         "logarithmic map of the point. The texture coordinates of each vertex are its place on the plane "
         "that touches the surface at the point, so that a picture can be laid onto the surface there, as a "
         "decal: the point is at (0.5, 0.5), and a step away from it keeps its length and its direction. The "
         "picture is <b>Scale</b> times as wide as the disk of the <b>Radius</b>; <b>Rotation</b> turns it. "
         "The quality is the angle of the direction, from 0 to 2 pi; it is shown as a colour wheel, with "
         "<b>Rings</b> of equal distance. Vertices that no path leads to, or only one longer than the "
         "radius, get texture coordinates (0, 0), quality <b>-1</b> and grey.</p><p>Paths start at the point "
         "of the surface nearest to <b>Start point</b>, which need not be a vertex, or, if its number is "
         "given, at <b>Start vertex</b>. Angles grow counter-clockwise as seen from the front of the faces; "
         "at a vertex they begin at the edge that leaves it in its last face, on a border at the border edge "
         "after which its faces follow, and are scaled so that they sum to 2 pi (on a border, to pi); in a "
         "face they begin at the side from its first corner to its second.</p><p>How to choose: exact up to "
         "rounding, without an index; <b>Radius</b> shortens the propagation. With <b>Per wedge</b>, faces "
         "that reach beyond the radius have texture coordinates (0, 0) at all corners; otherwise they hold a "
         "smeared rim of the picture. To keep all of a picture, take a radius a little larger and a scale "
         "that much smaller. On a curved surface the picture is stretched away from the point: "
         "<i>mean_distortion</i> and <i>max_distortion</i> say by what fraction the lengths of edges in the "
         "picture differ from those on the surface.</p><p>See:<br/>" +
         reference_of_exact() +
         "<br/><i>Ryan Schmidt, Cindy Grimm, Brian Wyvill</i><br/><b>\"Interactive decal compositing with "
         "discrete exponential maps\"</b><br/>ACM "
         "Transactions on Graphics 25(3), 2006.</p>";
}

QString help_on_curves() {
  return "<p>Lines are replaced by points at most <b>Spacing</b> apart, ends included. The distance is then "
         "never too short and at most half the spacing too long, at a distance d much larger than the "
         "spacing at most about spacing<sup>2</sup> / (8 d). ";
}

}  // namespace

std::vector<FilterRow> distance_rows() {
  const QString chosen = help_on_field() + help_on_choosing() + references_of_index();
  const QString exact = help_on_field() + help_on_exact();
  return {
      field_row(
          "Geodesic distance from a given point (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_given_point_per_vertex",
          "<p>Geodesic distance of every vertex from a given point: the length of the shortest path over "
          "the surface.</p>" +
              help_on_start() + chosen,
          [](const MeshDocument& document) {
            return list_of(start_parameters(document, start_meaning), method_and_max_distance(document));
          },
          [](FilterCall& call) { return distances_from_point(call, method_of(call)); }),
      field_row("Geodesic distance from the selection (VoroGeo)",
                "compute_scalar_by_vorogeo_distance_from_selection_per_vertex",
                "<p>Geodesic distance of every vertex from the nearest selected vertex: the length of the "
                "shortest path over the surface.</p>" +
                    chosen,
                method_and_max_distance,
                [](FilterCall& call) { return distances_from_selection(call, method_of(call)); }),
      field_row("Geodesic distance from the border (VoroGeo)",
                "compute_scalar_by_vorogeo_distance_from_border_per_vertex",
                "<p>Geodesic distance of every vertex from the nearest border vertex: the length of the "
                "shortest path over the surface. Border vertices are those of edges with only one face. A "
                "component without a border is unreachable.</p>" +
                    chosen,
                method_and_max_distance, distances_from_border),
      field_row(
          "Exact geodesic distance from a given point (VoroGeo)",
          "compute_scalar_by_exact_geodesic_distance_from_given_point_per_vertex",
          "<p>Exact geodesic distance of every vertex from a given point: the length of the shortest "
          "path over the surface.</p>" +
              help_on_start() + exact,
          [](const MeshDocument& document) {
            return list_of(start_parameters(document, start_meaning), field_parameters(document));
          },
          [](FilterCall& call) { return distances_from_point(call, Answer::exact); }),
      field_row("Exact geodesic distance from the selection (VoroGeo)",
                "compute_scalar_by_exact_geodesic_distance_from_selection_per_vertex",
                "<p>Exact geodesic distance of every vertex from the nearest selected vertex: the length of "
                "the shortest path over the surface.</p>" +
                    exact,
                field_parameters,
                [](FilterCall& call) { return distances_from_selection(call, Answer::exact); }),
      field_row(
          "Geodesic distance from the points or lines of a layer (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_layer_per_vertex",
          "<p>Geodesic distance of every vertex from the nearest point of another layer: its vertices "
          "and, if it has edges, the lines between them. Each point is first moved to the nearest point "
          "of the surface, which need not be a vertex; <i>snap_distance</i> is the farthest move.</p>" +
              help_on_curves() +
              "The custom vertex attribute <i>nearest_source</i> gets the number of the nearest vertex "
              "of the source layer, -1 where there is none.</p>" +
              chosen,
          from_layer_parameters, distances_from_layer),
      field_row("Geodesic distance from edges (VoroGeo)",
                "compute_scalar_by_vorogeo_distance_from_edges_per_vertex",
                "<p>Geodesic distance of every vertex from the nearest selected edge, or from the nearest "
                "border edge if <b>From the border</b> is ticked.</p>" +
                    help_on_curves() + "</p>" + chosen,
                from_edges_parameters, distances_from_edges),
      field_row(
          "Signed geodesic distance from a curve or a region (VoroGeo)",
          "compute_scalar_by_vorogeo_signed_distance_per_vertex",
          "<p>Geodesic distance of every vertex from closed curves, or from the border of the selected "
          "faces: negative inside, positive outside. It becomes the vertex quality, in the unit of the "
          "mesh, and a colour: green on the curves, red inside, blue outside. Vertices of components "
          "without a curve get quality 0 and grey and are counted in the log.</p><p>If <b>Curve "
          "layer</b> is the current layer, the region is its selected faces. If it is another one, the "
          "curves are the lines of that, such as isolines or a plane section, whose points are moved to "
          "the nearest point of the surface; <i>snap_distance</i> is the farthest move, and one of more "
          "than <b>Max snap distance</b> is an error unless that is 0. Inside a curve is the side "
          "without a border of the surface, otherwise the smaller one; behind each further curve the sides "
          "change.</p><p>How to choose: curves do not branch; an open one is closed by the shortest path "
          "from its end to its beginning, and points of a layer without lines are joined in their order. "
          "Curves that touch themselves or each other, or have the same side left and right, as round a "
          "handle, are an error. Distances are exact, from the curves themselves. Lines at a distance from "
          "them on both sides are those of <i>Isolines of a geodesic distance (VoroGeo)</i>: untick "
          "<b>Quality is a distance</b> there.</p><p>Returns <i>min_distance</i> and <i>max_distance</i>, of "
          "the vertices deepest inside and farthest outside, and <i>unreachable_vertices</i>.</p>"
          "<p>See:<br/>" +
              reference_of_exact() + "</p>",
          region_parameters, signed_distances),
      {"Geodesic directions from a given point (VoroGeo)",
       "compute_scalar_by_vorogeo_directions_from_given_point_per_vertex", help_on_directions(),
       FilterPlugin::FilterClass(FilterPlugin::Texture | FilterPlugin::VertexColoring |
                                 FilterPlugin::Quality),
       MeshModel::MM_VERTTEXCOORD | MeshModel::MM_WEDGTEXCOORD | MeshModel::MM_VERTQUALITY |
           MeshModel::MM_VERTCOLOR,
       directions_parameters, directions_from_point}};
}

}  // namespace vorogeo::plugin
