// Filters for paths: the distance of two points; shortest paths between two and through several points,
// smooth and tight curves, loops, girths and profiles, as layers.
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "filters/rows.h"
#include "layers/answering.h"
#include "layers/curves.h"
#include "layers/path_lines.h"
#include "layers/points.h"
#include "layers/results.h"
#include "tasks/curves.h"
#include "tasks/girth.h"
#include "tasks/loops.h"
#include "tasks/path_through.h"
#include "tasks/profile.h"

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
  const Answer method = method_of(call);
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

// ---- Filters: shortest paths between two points and through several, and smooth curves, as polyline layers

/// A direction of the scene; not checked.
Point vector_of(const FilterCall& call, const char* parameter) {
  const Point3m given = call.parameters.getPoint3m(parameter);
  return {double(given[0]), double(given[1]), double(given[2])};
}

/// Adds a path as a layer, in which the vertices are selected from which a step runs over a gap; logs its
/// length. \return length, certified, points, steps_over_gaps, gap_length.
Results add_path_layer(FilterCall& call, const char* name, const Mesh& mesh, const ExactPath& result) {
  const PathLines polyline = lines_of(mesh, result.path);
  const std::vector<bool> over_gap = steps_over_gaps(mesh, result.path.points);
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
    add_polyline_layer(call.document, call.layer, name, polyline.lines, polyline.along, true);
    text << name << " of length " << logged_length(result.path.length) << " over "
         << polyline.lines.points.size() << " points";
    if (!marked.empty()) {
      text << "; " << marked.size() << " of its steps run over gaps, a length of "
           << logged_length(gap_length) << ", from selected vertices";
      for (const std::size_t point : marked) call.document.mm()->cm.vert[point].SetS();
    }
  }
  call.log(text.str());
  return {{"length", result.path.length},
          {"certified", result.certified},
          {"points", static_cast<int>(polyline.lines.points.size())},
          {"steps_over_gaps", static_cast<int>(marked.size())},
          {"gap_length", gap_length}};
}

/// The same for the answer of a task about points. \return all that the filter returns.
Results add_path_layer(FilterCall& call, const char* name, LayerSurface& layer, const TaskPoints& points,
                       AnswerOfLayer<ExactPath> answer) {
  Results results = add_path_layer(call, name, *layer.mesh(), answer.found);
  results["snap_distance"] = points.snap_distance;
  results.merge(answer.about);
  return results;
}

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
  const Answer method = method_of(call);
  const auto ask = [&](Surface& surface, Answered& answered, const Progress& progress) {
    return surface.path(source.point, target.point, method, {exact, certify}, answered, progress);
  };
  auto answer = ask_surface(call, *layer, "Shortest path", ask);
  rest_if_large(*layer, answer.answered, mesh->vertex_count());
  call.progress.report(1.0, "Shortest path");
  Results results = add_path_layer(call, "Geodesic path", *mesh, answer.found);
  results["seconds"] = answer.answered.seconds;
  results.merge(about_end_points(ends));
  results.merge(answer.about);
  return results;
}

RichParameterList path_through_parameters(const MeshDocument& document) {
  return list_of(task_point_parameters(document, "points that the path shall pass through"),
                 RichBool("closed", false, "Closed", "From the last point back to the first one."),
                 RichBool("guides", false, "Guides",
                          "The points between the ends say which way the path leads, not where."));
}

Results draw_path_through(FilterCall& call) {
  const auto layer = layer_of(call);
  const TaskPoints points = task_points(call, *layer, "that the path shall pass through");
  const bool closed = call.parameters.getBool("closed");
  return add_path_layer(
      call, "Geodesic path", *layer, points,
      ask_task_by(Answer::automatic, call, *layer, "Shortest path through points",
                  call.parameters.getBool("guides") ? tighten : path_through, points.points, closed));
}

RichParameterList smooth_curve_parameters(const MeshDocument& document) {
  return list_of(task_point_parameters(document, "points that the curve shall pass through"),
                 RichBool("closed", false, "Closed", "From the last point on to the first one."),
                 RichInt("samples", 16, "Samples",
                         "Points of the curve from each given point to the next; shortest paths join them."));
}

Results draw_smooth_curve(FilterCall& call) {
  const Index samples = number_of(call, "samples", 1, ". Give 1 or more.");
  const auto layer = layer_of(call);
  const TaskPoints points = task_points(call, *layer, "that the curve shall pass through");
  const bool closed = call.parameters.getBool("closed");
  return add_path_layer(call, "Smooth curve", *layer, points,
                        ask_task_by(Answer::automatic, call, *layer, "Smooth curve through points", spline,
                                    points.points, closed, samples));
}

// ---- Filters: closed curves pulled tight, and shortest loops through a point, as polyline layers

Results draw_tight_curve(FilterCall& call) {
  const auto layer = layer_of(call);
  const TaskPoints curve = curve_in_order(call, *layer);
  return add_path_layer(
      call, "Tight curve", *layer, curve,
      ask_task_by(Answer::automatic, call, *layer, "Pulling the curve tight", tighten, curve.points, true));
}

RichParameterList loop_parameters(const MeshDocument& document) {
  return list_of(start_parameters(document, "What the loop goes through: the nearest point of the surface"),
                 curve_layer_parameters(
                     document,
                     "The layer with a curve, moved to the surface, that goes round what the loop shall go "
                     "round. The current layer: the shortest of all loops."));
}

Results draw_shortest_loop(FilterCall& call) {
  const auto layer = layer_of(call);
  const SnappedPoint start = start_point(call, *layer);
  const TaskPoints like = curve_is_selected(call) ? TaskPoints() : curve_in_order(call, *layer);
  auto [loop, answered, results] =
      ask_task_by(Answer::exact, call, *layer, "Shortest loop", shortest_loop, start.point, like.points);
  results.merge(add_path_layer(call, "Shortest loop", *layer->mesh(), loop));
  results.merge(about_start(*layer, *layer->mesh(), start));
  results["curve_snap_distance"] = like.snap_distance;
  return results;
}

// ---- Filter: what lies along a curve, as a polyline layer with attributes and as a table

/// By column of the table: its name, and its values.
struct ProfileColumn {
  const char* name;
  const char* label;
  std::vector<double> Profile::*values;
};
constexpr std::array<ProfileColumn, 5> profile_columns{{{"length", "Length", &Profile::along},
                                                        {"height", "Height", &Profile::height},
                                                        {"angle", "Angle", &Profile::angle},
                                                        {"curvature", "Curvature", &Profile::curvature},
                                                        {"thickness", "Thickness", &Profile::thickness}}};

RichParameterList profile_parameters(const MeshDocument& document) {
  QStringList labels;
  for (const ProfileColumn& column : profile_columns) labels << column.label;
  return list_of(curve_parameters(document),
                 RichDirection("up", Point3m(0, 0, 1), "Up", "The direction in which heights count."),
                 RichEnum("quality", 1, labels, "Quality", "Which of these the vertices have as quality."),
                 csv_file_parameter());
}

std::string csv_of(const Profile& found) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  const auto add_row = [&](auto&& cell) {
    for (const ProfileColumn& column : profile_columns) {
      if (&column != profile_columns.data()) text << ',';
      cell(column);
    }
    text << '\n';
  };
  add_row([&](const ProfileColumn& column) { text << column.name; });
  for (std::size_t i = 0; i < found.along.size(); ++i) {
    add_row([&](const ProfileColumn& column) { text << (found.*column.values)[i]; });
  }
  return text.str();
}

Results draw_profile(FilterCall& call) {
  const auto file = csv_file(call);
  const int quality = call.parameters.getEnum("quality");
  if (quality < 0 || quality >= static_cast<int>(profile_columns.size())) {
    refuse(call, "quality", quality, ". Give length, height, angle, curvature or thickness, or 0 to 4.");
  }
  const Point up = vector_of(call, "up");
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const TaskPoints curve = curve_in_order(call, *layer);
  SurfacePath path;
  const auto ask = [&](Surface& surface, const TaskOptions& options) {
    path = path_through(surface, curve.points, false, options).path;
    const auto locate = [&]() -> const SurfaceLocator& { return *layer->locator(); };
    return profile(*mesh, locate, path.points, up, layer->placement().is_mirrored());
  };
  auto [found, answered, results] = ask_task_by(Answer::automatic, call, *layer, "Profile of a curve", ask);
  write_csv(call, file, csv_of(found));
  std::vector<double> shown = found.*profile_columns[static_cast<std::size_t>(quality)].values;
  for (double& value : shown) value = std::isfinite(value) ? value : quality_without_distance;
  add_polyline_layer(call.document, call.layer, "Profile", lines_of(*mesh, path).lines, shown, true);
  CMeshO& line = call.document.mm()->cm;
  for (const ProfileColumn& column : profile_columns) {
    const std::vector<double>& values = found.*column.values;
    auto attribute = vcg::tri::Allocator<CMeshO>::GetPerVertexAttribute<Scalarm>(line, column.name);
    for (std::size_t i = 0; i < values.size(); ++i) attribute[i] = static_cast<Scalarm>(values[i]);
    results[column.name] = as_vector(values);
  }
  const auto [lowest, highest] = std::ranges::minmax(found.height);
  call.log("Profile of length " + logged_length(found.along.back()) + " over " +
           std::to_string(found.along.size()) + " points, between the heights " + logged_length(lowest) +
           " and " + logged_length(highest));
  results["points"] = static_cast<int>(found.along.size());
  results["snap_distance"] = curve.snap_distance;
  return results;
}

// ---- Filter: how far it is round a limb, as polyline layers

RichParameterList girth_parameters(const MeshDocument& document) {
  return list_of(
      start_parameters(document, "Where the girth is measured: at the nearest point of the surface"),
      RichDirection("normal", Point3m(0, 0, 0), "Normal (0: chosen)",
                    "The plane is at right angles to it; 0 0 0: that of the shortest section."));
}

Results draw_girth(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const SnappedPoint start = start_point(call, *layer);
  std::optional<Point> normal = vector_of(call, "normal");
  if (normal == Point{}) normal.reset();
  auto [limb, answered, results] =
      ask_task_by(Answer::exact, call, *layer, "Girth", girth, start.point, normal);
  std::vector<Point> tape = limb.tape;
  tape.push_back(tape.front());
  const auto add = [&](const char* name, const PathLines& line, bool make_current) {
    add_polyline_layer(call.document, call.layer, name, line.lines, line.along, make_current);
  };
  add("Girth: tape", lines_through(tape), false);
  if (limb.loop.points.size() > 1) add("Girth: loop", lines_of(*mesh, limb.loop), false);
  // In space like the tape, whatever the metric.
  add("Girth: section", lines_through(positions_of(*mesh, limb.section.points)), true);
  call.log("Girth: section " + logged_length(limb.section.length) + ", tape " +
           logged_length(limb.tape_length) + ", loop " + logged_length(limb.loop.length));
  results["section_length"] = limb.section.length;
  results["tape_length"] = limb.tape_length;
  results["loop_length"] = limb.loop.length;
  results["normal"] = as_vector(limb.normal);
  results.merge(about_start(*layer, *mesh, start));
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
       FilterPlugin::Measure, MeshModel::MM_NONE, path_parameters, draw_path},
      {"Shortest path through points (VoroGeo)", "generate_polyline_by_vorogeo_path_through_points",
       "<p>The shortest path over the surface that passes points in their order, as a new polyline layer, "
       "which becomes the current one; the quality of its vertices is the length up to there. With "
       "<b>Closed</b> it goes from the last point back to the first. With <b>Guides</b> it is pulled tight, "
       "with its ends held or, if closed, all the way round: the points between say which way it leads. "
       "Vertices from which a step runs over a bridged gap are selected.</p>" +
           help_on_task_points() +
           "<p>How to choose: the vertices of a point layer are passed in the order in which that has them, "
           "selected ones in that of their numbers. Each leg is the exact shortest path; an index only makes "
           "it faster. Guides lead past the side of a hole, a handle or a limb that a shortest path would "
           "not take.</p><p>Returns the <i>length</i>, the number of <i>points</i> and whether the path is "
           "<i>certified</i>: proven to be the shortest through these points.</p>" +
           references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, path_through_parameters, draw_path_through},
      {"Smooth curve through points (VoroGeo)", "generate_polyline_by_vorogeo_smooth_curve",
       "<p>A smooth curve over the surface through points in their order, as a new polyline layer, which "
       "becomes the current one; the quality of its vertices is the length up to there. Between two points "
       "it is a cubic Bezier curve, made by de Casteljau's construction with shortest paths as its straight "
       "lines; at each point its direction is half of the difference of the directions to the next point and "
       "to the one before, in their lengths. With <b>Closed</b> it goes on from the last point to the "
       "first.</p>" +
           help_on_task_points() +
           "<p>How to choose: the vertices of a point layer are passed in the order in which that has them, "
           "selected ones in that of their numbers. More <b>Samples</b> make the curve smoother and take as "
           "many times longer. Where a shortest path jumps from one side of a hill to the other, so does the "
           "curve: give a point between.</p><p>Returns the <i>length</i> and the number of <i>points</i>. "
           "The mesh is not changed.</p><p>See:<br/><i>F. C. Park, B. Ravani</i><br/><b>\"Bezier curves on "
           "Riemannian manifolds and Lie groups with kinematics applications\"</b><br/>Journal of Mechanical "
           "Design 117(1), 1995.<br/><i>Edwin Catmull, Raphael Rom</i><br/><b>\"A class of local "
           "interpolating splines\"</b><br/>Computer Aided Geometric Design, 1974.</p>",
       FilterPlugin::Measure, MeshModel::MM_NONE, smooth_curve_parameters, draw_smooth_curve},
      {"Closed curve pulled tight (VoroGeo)", "generate_polyline_by_vorogeo_tight_curve",
       "<p>Pulls a closed curve tight, as a rubber band, until it is a closed geodesic: straight over the "
       "surface all the way round. It slides to the nearest place where it cannot become shorter, such as "
       "the neck of a vase; another curve that goes round likewise may be shorter. The result is a new "
       "polyline layer, which becomes the current one; the quality of its vertices is the length up to "
       "there.</p>" +
           help_on_curve() +
           "<p>How to choose: the curve is one line that does not branch; an open one is closed by the "
           "shortest path from its end to its beginning, and points of a layer without lines are joined in "
           "their order. Where points lie so far apart that they share no face, shortest paths join them. "
           "It must go round something that holds it: a handle, a border, a limb behind a neck. Where it "
           "slips off, that is an error, which says where.</p><p>Returns the <i>length</i>, the number of "
           "<i>points</i>, and <i>snap_distance</i>. The mesh is not changed.</p><p>See:<br/><i>George D. "
           "Birkhoff</i><br/><b>\"Dynamical systems with two degrees of freedom\"</b><br/>Transactions of "
           "the American Mathematical Society 18(2), 1917.</p>",
       FilterPlugin::Measure, MeshModel::MM_NONE, curve_parameters, draw_tight_curve},
      {"Shortest loop through a point (VoroGeo)", "generate_polyline_by_vorogeo_shortest_loop",
       "<p>The shortest closed curve through a point that cannot be contracted to it: round a handle, round "
       "a tunnel, or between two borders. The result is a new polyline layer, which becomes the current one; "
       "the quality of its vertices is the length up to there.</p><p>The loop goes through the point of the "
       "surface nearest to <b>Start point</b>, which need not be a vertex, or, if its number is given, "
       "through <b>Start vertex</b>. There it may bend; elsewhere it is straight. If <b>Curve layer</b> is "
       "another layer, the loop is the one to which its curve, led to the point, can be pulled: round the "
       "same handle, say. The points of the curve are moved to the surface, by "
       "<i>curve_snap_distance</i> at most.</p><p>How to choose: on a "
       "surface without handles and with at most one border, such as a ball, every loop contracts, which is "
       "an error; take <i>Geodesic girth at a point (VoroGeo)</i> there. Exact, without an index.</p>"
       "<p>Returns the <i>length</i> and the number of <i>points</i>. The mesh is not changed.</p>"
       "<p>See:<br/><i>Jeff Erickson, Sariel Har-Peled</i><br/><b>\"Optimally cutting a surface into a "
       "disk\"</b><br/>Discrete and Computational Geometry 31(1), 2004.</p>",
       FilterPlugin::Measure, MeshModel::MM_NONE, loop_parameters, draw_shortest_loop},
      {"Profile of a curve (VoroGeo)", "generate_polyline_by_vorogeo_profile",
       "<p>What lies along a curve over the surface: the length so far, the height in the direction "
       "<b>Up</b>, the angle of the normal with it (in radians: 0 on level ground, a quarter turn on a "
       "wall), the curvature of the surface in the direction of the curve (1/r round a ball, below 0 in "
       "hollows), and the thickness, how far it is against the normal to the next face. The curve is a new "
       "polyline layer, which becomes the current one, with these five as custom attributes of its vertices, "
       "and <b>Quality</b> says which of them is the quality; where it is infinite, the quality is -1. "
       "<b>CSV file</b> writes them as a table.</p>" +
           help_on_curve() +
           "<p>How to choose: the curve is one line that does not branch; shortest paths join its points, "
           "and those of a layer without lines in their order. Normals are those of most faces: where they "
           "lead inwards, turn all faces over first. Curvature comes from the normals of the vertices and is "
           "as rough as these.</p><p>Returns the columns of the table as vectors: <i>length</i>, "
           "<i>height</i>, <i>angle</i>, <i>curvature</i>, <i>thickness</i> (infinity where no face lies "
           "below). The mesh is not changed.</p>" +
           references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, profile_parameters, draw_profile},
      {"Geodesic girth at a point (VoroGeo)", "generate_polyline_by_vorogeo_girth",
       "<p>How far it is round a limb, in three ways, each as a new polyline layer whose quality is the "
       "length so far. The <i>section</i>, which becomes the current layer, is where a plane through the "
       "point cuts the surface; only its part through the point counts, not other limbs. The <i>tape</i> is "
       "its convex hull, as a tape measure spans hollows. The <i>loop</i> is the section pulled tight on the "
       "surface: it slides to the nearest place where it cannot become shorter. Where nothing holds it, "
       "there is no such layer, and the log says where it slips off.</p><p>The point is the one of the "
       "surface nearest to <b>Start point</b>, which need not be a vertex, or, if its number is given, "
       "<b>Start vertex</b>.</p><p>How to choose: leave <b>Normal</b> at 0 on a limb; the plane "
       "is then the one of the shortest closed section through the normal of the surface. Beside an edge or "
       "a corner that may be one that cuts it off: give the normal there. Section and tape are measured in "
       "space, the loop in the metric. A section that meets a border is an error.</p><p>Returns "
       "<i>section_length</i>, <i>tape_length</i>, <i>loop_length</i> (0 where it slips off) and the "
       "<i>normal</i>. The mesh is not changed.</p><p>See:<br/><i>George D. Birkhoff</i><br/><b>\"Dynamical "
       "systems with two degrees of freedom\"</b><br/>Transactions of the American Mathematical Society "
       "18(2), 1917.</p>",
       FilterPlugin::Measure, MeshModel::MM_NONE, girth_parameters, draw_girth}};
}

}  // namespace vorogeo::plugin
