// Filters that divide the surface: Voronoi regions, cut loci, patches in colours, isolines, cuts, polygons,
// areas of regions, extent, disks and bands.
#include <vcg/complex/algorithms/update/selection.h>

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <numbers>
#include <span>
#include <sstream>
#include <string>

#include "filters/rows.h"
#include "host/ticking.h"
#include "layers/answering.h"
#include "layers/curves.h"
#include "layers/path_lines.h"
#include "layers/points.h"
#include "layers/results.h"
#include "mesh/mesh_input.h"
#include "mesh/outliers.h"
#include "patches/partition.h"
#include "support/error.h"
#include "support/memory.h"
#include "tasks/bands.h"
#include "tasks/curve_sources.h"
#include "tasks/cut.h"
#include "tasks/cut_locus.h"
#include "tasks/extent.h"
#include "tasks/path_through.h"
#include "tasks/polygon.h"
#include "tasks/region_areas.h"
#include "tasks/surface_lines.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo::plugin {

// ---- Filter: geodesic Voronoi regions of points, as colours, quality and a layer of borders

namespace {

RichParameterList voronoi_parameters(const MeshDocument& document) {
  return list_of(task_point_parameters(document, "points whose regions are wanted"),
                 RichBool("borders", true, "Borders", "Add the borders of the regions as a polyline layer."),
                 exact_parameter(), direction_parameter());
}

/// Colours by the regions of the faces; faces in no region are given one of their own for this purpose.
PatchColoring coloring_of(const Mesh& mesh, const VoronoiRegions& regions, std::size_t count) {
  std::vector<Index> region = regions.face_region;
  for (Index& r : region) {
    if (r == no_index) r = static_cast<Index>(count);
  }
  return color_neighbors_differently(mesh, region);
}

/// Colours the faces by the region of their centre; grey where that is no_index.
void color_faces(FilterCall& call, const LayerSurface& layer, const Mesh& mesh, std::span<const Index> region,
                 const PatchColoring& coloring) {
  for (int face : layer.arrays().input_of_face) call.layer.cm.face[face].C() = grey();
  for (Index f : InputMap(mesh).central_parts()) {
    if (region[f] == no_index) continue;
    const Rgb& color = coloring.palette[coloring.color_of_patch[region[f]]];
    call.layer.cm.face[layer.host_face(mesh, f)].C() = {color[0], color[1], color[2], 255};
  }
}

Results color_voronoi_regions(FilterCall& call) {
  const auto layer = layer_of(call);
  const TaskPoints points = task_points(call, *layer, "whose regions are wanted");
  auto [regions, answered, results] =
      ask_task(call, *layer, "Voronoi regions", voronoi_regions, points.points);
  const auto shared_mesh = layer->mesh();
  const Mesh& mesh = *shared_mesh;
  const PatchColoring coloring = coloring_of(mesh, regions, points.size());
  if (call.parameters.getBool("borders")) {
    add_polyline_layer(call.document, call.layer, "Voronoi borders", regions.borders, {}, false);
  }
  call.layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_FACECOLOR);
  int unreached = 0;
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
    call.layer.cm.vert[layer->host_vertex(v)].Q() = static_cast<Scalarm>(regions.vertex_region[v]);
    unreached += regions.vertex_region[v] == no_index;
  }
  color_faces(call, *layer, mesh, regions.face_region, coloring);
  call.log("Voronoi regions of " + std::to_string(points.size()) + " " + points.what +
           "; their borders are " + logged_length(total_length(regions.borders)) + " long");
  if (unreached > 0) {
    call.log("No path leads to " + std::to_string(unreached) +
             " vertices, in other components than the points; their quality is -1");
  }
  results["regions"] = static_cast<int>(points.size());
  results["vertices"] = as_vector(points.numbers);
  results["snap_distance"] = points.snap_distance;
  results["areas"] = as_vector(regions.area);
  results["border_length"] = total_length(regions.borders);
  results["unreachable_vertices"] = unreached;
  return results;
}

// ---- Filter: where several shortest paths end, as a polyline layer

RichParameterList cut_locus_parameters(const MeshDocument& document) {
  return list_of(task_point_parameters(document, "points at which paths begin"),
                 RichFloat("min_angle", 30, "Least angle",
                           "Of the directions in which two shortest paths arrive, in degrees; 0: any."));
}

Results draw_cut_locus(FilterCall& call) {
  const double degrees = call.parameters.getFloat("min_angle");
  if (!(degrees >= 0.0 && degrees <= 180.0)) {
    refuse(call, "min_angle", degrees, ". Give an angle from 0 to 180 degrees.");
  }
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const TaskPoints sources = task_points(call, *layer, "at which paths begin");
  auto [locus, answered, results] =
      ask_task_by(Answer::exact, call, *layer, "Cut locus", cut_locus, sources.points,
                  degrees / 180.0 * std::numbers::pi, unreachable);
  const SurfaceLines lines{positions_of(*mesh, locus.points), std::move(locus.edges)};
  const std::string of = "Cut locus of " + std::to_string(sources.size()) + " " + sources.what + ": ";
  add_polyline_layer(call.document, call.layer, "Cut locus", lines, locus.distance, true);
  call.log(of + (lines.segments.empty() ? "no line, as nowhere two shortest paths differ by this angle"
                                        : std::to_string(lines.segments.size()) + " segments, " +
                                              logged_length(total_length(lines)) + " long in all"));
  if (answered.unreached > 0) {
    call.log("No path leads to " + std::to_string(answered.unreached) +
             " vertices, in components without a source; they have no lines");
  }
  results["segments"] = static_cast<int>(lines.segments.size());
  results["length"] = total_length(lines);
  results["unreachable_vertices"] = answered.unreached;
  results["snap_distance"] = sources.snap_distance;
  return results;
}

// ---- Filter: colour the faces by the patches of one layer of the index

RichParameterList patch_colors_parameters(const MeshDocument&) {
  return list_of(RichInt("layer", 1, "Layer", "Layer of patches: 1 (large patches) or 2 (small patches)."));
}

Results color_patches(FilterCall& call) {
  const int number = number_of(call, "layer", 1,
                               ". The index has two layers: give 1 (large patches) or 2 (small patches).", 2);
  const auto layer = layer_of(call);
  const bool is_reused = layer->index() != nullptr;
  if (!is_reused) build_index(call, *layer, {}, call.progress.part(0.0, 0.9));
  const auto index = layer->index();
  const Mesh& mesh = *index->mesh();
  const auto patches = index->face_patches(number);
  const PatchColoring coloring = color_neighbors_differently(mesh, patches);
  call.progress.report(1.0, "Writing colours");

  call.layer.updateDataMask(MeshModel::MM_FACECOLOR);
  color_faces(call, *layer, mesh, patches, coloring);
  call.log("Patches of layer " + std::to_string(number) + ": " +
           std::to_string(coloring.color_of_patch.size()) + ", in " + std::to_string(coloring.colors_used) +
           " colours");
  return {{"patches", static_cast<int>(coloring.color_of_patch.size())},
          {"colors", coloring.colors_used},
          {"index_reused", is_reused},
          {"index_seconds", is_reused ? 0.0 : index->statistics().seconds}};
}

// ---- Filters: lines of equal vertex quality as a polyline layer, and the parts between them as layers

RichParameterList level_parameters(int lines) {
  return list_of(RichInt("line_number", lines, "Lines",
                         "Number of values, evenly spaced between the least and the greatest quality."),
                 RichString("values", "", "Values",
                            "The values themselves, separated by spaces or semicolons; used if not empty."),
                 RichBool("is_distance", true, "Quality is a distance",
                          "Negative quality means no distance, and lines cross edges as distances do."));
}

std::vector<double> values_of(const FilterCall& call, double low, double high) {
  std::vector<double> values;
  QString text = call.parameters.getString("values");
  const QStringList words = text.replace(';', ' ').split(' ', Qt::SkipEmptyParts);
  for (const QString& word : words) {
    bool is_number = false;
    values.push_back(word.toDouble(&is_number));
    if (is_number && std::isfinite(values.back())) continue;
    throw InvalidInput(named(call, "values") + " holds '" + word.toStdString() +
                       "', which is not a finite number. Separate numbers by spaces or semicolons.");
  }
  if (!values.empty()) return values;
  const int count = number_of(call, "line_number", 1, ". Give 1 or more, or the values themselves.");
  require_memory(24.0 * count, 0, "The list of " + std::to_string(count) + " values", "Give fewer lines.");
  values.reserve(static_cast<std::size_t>(count));
  for (int i = 1; i <= count; ++i) values.push_back(low + (high - low) * i / (count + 1));
  return values;
}

/// The quality of the vertices as a field, and the values at which lines run.
struct QualityLevels {
  std::vector<double> field;
  std::vector<double> values;
  Interpolation interpolation;
};

QualityLevels quality_levels(const FilterCall& call, LayerSurface& layer) {
  if (!call.layer.hasDataMask(MeshModel::MM_VERTQUALITY)) {
    throw InvalidInput("The vertices have no quality. Compute a distance first.");
  }
  const bool is_distance = call.parameters.getBool("is_distance");
  const auto mesh = layer.mesh();
  std::vector<double> field(static_cast<std::size_t>(mesh->given_vertex_count()));
  double low = unreachable;
  double high = -unreachable;
  for (Index v = 0; v < mesh->given_vertex_count(); ++v) {
    const double quality = call.layer.cm.vert[layer.host_vertex(v)].cQ();
    field[v] = is_distance && quality < 0.0 ? unreachable : quality;
    if (!std::isfinite(field[v])) continue;
    low = std::min(low, field[v]);
    high = std::max(high, field[v]);
  }
  if (low > high) {
    throw InvalidInput("No vertex has a quality that a line could be drawn for. Compute a distance first.");
  }
  return {std::move(field), values_of(call, low, high),
          is_distance ? Interpolation::distance : Interpolation::linear};
}

Results draw_isolines(FilterCall& call) {
  const auto layer = layer_of(call);
  const QualityLevels levels = quality_levels(call, *layer);
  const Isolines found = run_ticking(call.progress, "Isolines", [&](const Progress& progress) {
    return isolines(*layer->mesh(), levels.field, levels.values, levels.interpolation, progress);
  });
  std::vector<double> quality;
  for (Index level : found.level_of_point) quality.push_back(levels.values[level]);
  add_polyline_layer(call.document, call.layer, "Isolines", found.lines, quality, true);
  call.log("Isolines: " + std::to_string(found.lines.segments.size()) + " segments, " +
           logged_length(total_length(found.lines)) + " long in all");
  return {{"segments", static_cast<int>(found.lines.segments.size())},
          {"length", total_length(found.lines)},
          {"values", as_vector(levels.values)}};
}

QString name_of_part(std::size_t region, const std::vector<double>& values) {
  if (region > values.size()) return "Part without distance";
  if (region == 0) return QString("Part below %1").arg(values.front());
  if (region == values.size()) return QString("Part from %1").arg(values.back());
  return QString("Part from %1 to %2").arg(values[region - 1]).arg(values[region]);
}

Results cut_along_isolines(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  QualityLevels levels = quality_levels(call, *layer);
  std::vector<double>& values = levels.values;
  std::ranges::sort(values);
  values.erase(std::ranges::unique(values).begin(), values.end());
  const CutMesh cut = run_ticking(call.progress, "Cutting along isolines", [&](const Progress& progress) {
    return cut_at_levels(*mesh, levels.field, values, levels.interpolation, progress);
  });
  // Faces by region; those without a distance come last.
  const auto region_without = static_cast<Index>(values.size()) + 1;
  std::vector<std::vector<Index>> faces(values.size() + 2);
  for (Index f = 0; f < static_cast<Index>(cut.faces.size()); ++f) {
    faces[cut.region[f] == no_index ? region_without : cut.region[f]].push_back(f);
  }
  std::vector<int> regions;
  for (std::size_t region = 0; region < faces.size(); ++region) {
    if (faces[region].empty()) continue;
    const QString name = name_of_part(region, values);
    add_part_layer(call, name, *layer, *mesh, cut, faces[region]);
    regions.push_back(region > values.size() ? no_index : static_cast<int>(region));
    call.log(name.toStdString() + ": " + std::to_string(faces[region].size()) + " faces");
  }
  return {{"parts", static_cast<int>(regions.size())},
          {"regions", as_vector(regions)},
          {"values", as_vector(values)}};
}

// ---- Filter: the parts on both sides of a curve as layers

Results cut_along_curve(FilterCall& call) {
  const auto layer = layer_of(call);
  const TaskPoints curve = curve_in_order(call, *layer);
  const auto cut_by = [&](Surface& surface, const TaskOptions& options) {
    const ExactPath path = path_through(surface, curve.points, false, options);
    return cut_along(*surface.mesh(), {path.path.points}, options.progress);
  };
  auto [cut, answered, results] =
      ask_task_by(Answer::automatic, call, *layer, "Cutting along the curve", cut_by);
  // Parts that the curve does not touch are left out.
  std::map<Index, std::vector<Index>> faces_of;
  for (std::size_t f = 0; f < cut.faces.size(); ++f) {
    if (cut.side[f] != 0) faces_of[cut.region[f]];
  }
  if (faces_of.size() < 2) {
    throw InvalidInput(
        "The curve does not divide the surface: the same part lies on both sides of it. Close it, or lead it "
        "from border to border.");
  }
  for (Index f = 0; f < static_cast<Index>(cut.faces.size()); ++f) {
    const auto part = faces_of.find(cut.region[f]);
    if (part != faces_of.end()) part->second.push_back(f);
  }
  std::vector<std::size_t> counts;
  for (const auto& [region, faces] : faces_of) {
    counts.push_back(faces.size());
    add_part_layer(call, QString("Part %1 of the cut").arg(counts.size()), *layer, *layer->mesh(), cut,
                   faces);
    call.log("Part " + std::to_string(counts.size()) + " of the cut: " + std::to_string(faces.size()) +
             " faces");
  }
  results["parts"] = static_cast<int>(counts.size());
  results["faces"] = as_vector(counts);
  results["snap_distance"] = curve.snap_distance;
  return results;
}

// ---- Filters: select a geodesic disk, and measure its area

RichParameterList disk_parameters(const MeshDocument& document) {
  return list_of(length_parameter(document, "radius", 0.1, "Radius", "Greatest geodesic distance."),
                 RichInt("vertex_index", -1, "Vertex",
                         "Number of the vertex in the middle, counted from 0; -1: all selected vertices, or "
                         "the points given below."),
                 task_point_parameters(document, "points around which the disk shall lie"), exact_parameter(),
                 direction_parameter());
}

TaskPoints disk_sources(const FilterCall& call, LayerSurface& layer) {
  if (call.parameters.getInt("vertex_index") == -1) {
    return task_points(call, layer, "around which the disk shall lie");
  }
  TaskPoints sources;
  sources.points = std::vector<Index>{vertex_of(call, layer, "vertex_index")};
  return sources;
}

Results select_disk(FilterCall& call) {
  const auto layer = layer_of(call);
  const double radius = length_of(call, "radius", true);
  const TaskPoints sources = disk_sources(call, *layer);
  auto [disk, answered, results] =
      ask_task(call, *layer, "Geodesic disk", geodesic_disk, sources.points, radius);
  call.progress.report(1.0, "Selecting");
  vcg::tri::UpdateSelection<CMeshO>::VertexClear(call.layer.cm);
  vcg::tri::UpdateSelection<CMeshO>::FaceClear(call.layer.cm);
  for (Index v : disk.vertices) call.layer.cm.vert[layer->host_vertex(v)].SetS();
  for (Index f : disk.faces) call.layer.cm.face[layer->arrays().input_of_face[f]].SetS();
  call.log("Selected " + std::to_string(disk.vertices.size()) + " vertices and " +
           std::to_string(disk.faces.size()) + " faces");
  results["selected_vertices"] = static_cast<int>(disk.vertices.size());
  results["selected_faces"] = static_cast<int>(disk.faces.size());
  results["snap_distance"] = sources.snap_distance;
  return results;
}

/// Logs and returns the area and the border of a band; `within`: of what, for the log.
Results about_band(const FilterCall& call, const std::string& within, const Band& found) {
  std::ostringstream text;
  text << "Within " << within << " lies an area of " << std::setprecision(7) << found.area
       << " square mesh units; its border is " << logged_length(found.border_length) << " long";
  call.log(text.str());
  return {{"area", found.area}, {"border_length", found.border_length}};
}

Results measure_disk(FilterCall& call) {
  const auto layer = layer_of(call);
  const double radius = length_of(call, "radius", true);
  const TaskPoints sources = disk_sources(call, *layer);
  auto [disk, answered, results] =
      ask_task(call, *layer, "Area of a geodesic disk", band, sources.points, radius);
  results.merge(about_band(call, logged_length(radius), disk));
  results["snap_distance"] = sources.snap_distance;
  return results;
}

// ---- Filter: the area of a band round a curve

RichParameterList band_parameters(const MeshDocument& document) {
  return list_of(length_parameter(document, "width", 0.02, "Width", "Greatest geodesic distance."),
                 curve_parameters(document), spacing_parameter(document), exact_parameter(),
                 direction_parameter());
}

Results measure_band(FilterCall& call) {
  const auto layer = layer_of(call);
  const double width = length_of(call, "width", true);
  const auto mesh = layer->mesh();
  const double spacing = spacing_of(call, *mesh);
  const bool is_selected = curve_is_selected(call);
  std::vector<SurfacePoint> points;
  CurveLegs legs;
  if (is_selected) {
    const auto edges = edges_of_curve(*mesh, selected_curve(call, *layer, *mesh));
    for (const ExactSource& source : sources_along_edges(*mesh, edges, spacing))
      points.push_back(source.point);
  } else {
    legs = legs_of_curve(call, *layer);
  }
  const auto ask = [&](Surface& surface, const TaskOptions& options) {
    if (!is_selected) {
      points = points_along(*layer->surface(), legs, spacing, {options.by, options.progress.part(0.0, 0.2)});
    }
    return band(surface, points, width, {options.by, options.progress.part(0.2, 1.0), options.answered});
  };
  auto [found, answered, results] = ask_task(call, *layer, "Area of a band", ask);
  results.merge(about_band(call, logged_length(width) + " of the curve", found));
  results["snap_distance"] = legs.snap_distance;
  return results;
}

// ---- Filter: the area of selected faces or inside a curve

Results measure_region(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  RegionArea found;
  Results results;
  std::string what = "the selected faces";
  if (curve_is_selected(call)) {
    std::vector<Index> label;
    for (const auto is_selected : selected_region(call, *layer)) label.push_back(is_selected ? 0 : no_index);
    log_warnings(call, *layer);
    found = run_ticking(call.progress, "Area of a region", [&](const Progress& progress) {
      return region_areas(*mesh, label, 1, {Answer::automatic, progress}).front();
    });
    results["snap_distance"] = 0.0;
  } else {
    what = "the inside of the curve";
    const TaskPoints curve = curve_in_order(call, *layer);
    const auto ask = [&](Surface& surface, const TaskOptions& options) {
      return enclosed_area(*mesh, closed_line(surface, curve, options), {options.by, options.progress});
    };
    auto answer = ask_task_by(Answer::automatic, call, *layer, "Area of a region", ask);
    found = answer.found;
    results = std::move(answer.about);
    results["snap_distance"] = curve.snap_distance;
  }
  std::ostringstream text;
  text << "Area of " << what << ": " << std::setprecision(7) << found.area
       << " square mesh units; the border is " << logged_length(found.border_length) << " long";
  if (std::isfinite(found.volume)) text << "; it encloses " << found.volume << " cubic mesh units";
  call.log(text.str());
  results["area"] = found.area;
  results["border_length"] = found.border_length;
  results["volume"] = found.volume;
  return results;
}

// ---- Filter: a polygon of shortest paths

RichParameterList polygon_parameters(const MeshDocument& document) {
  return list_of(
      task_point_parameters(document, "corners of the polygon"),
      RichBool("convex_hull", false, "Convex hull",
               "The shortest closed curve around the points instead, with some of them as corners."),
      RichBool("cut_out", false, "Cut out", "Add the inside as a layer, cut along the border."));
}

Results draw_polygon(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const TaskPoints corners = task_points(call, *layer, "that are the corners of the polygon");
  const bool cut_out = call.parameters.getBool("cut_out");
  const bool is_hull = call.parameters.getBool("convex_hull");
  auto [polygon, answered, results] =
      ask_task_by(Answer::automatic, call, *layer, "Polygon of shortest paths",
                  is_hull ? convex_hull : geodesic_polygon, corners.points);
  SurfacePath border;
  for (const ExactPath& leg : polygon.legs) {
    // Each leg begins where the one before it ends.
    const auto begin = leg.path.points.begin() + (border.points.empty() ? 0 : 1);
    border.points.insert(border.points.end(), begin, leg.path.points.end());
  }
  vcg::tri::UpdateSelection<CMeshO>::FaceClear(call.layer.cm);
  for (const Index f : polygon.faces) call.layer.cm.face[layer->arrays().input_of_face[f]].SetS();
  const PathLines line = lines_of(*mesh, border);
  add_polyline_layer(call.document, call.layer, "Geodesic polygon", line.lines, line.along, true);
  if (cut_out) add_part_layer(call, "Polygon: inside", *layer, *mesh, polygon.cut, polygon.cut_faces);
  std::ostringstream text;
  text << (is_hull ? "Convex hull of " : "Polygon of ") << corners.size() << " " << corners.what << ": area "
       << std::setprecision(7) << polygon.area << " square mesh units, perimeter "
       << logged_length(polygon.perimeter) << "; " << polygon.faces.size() << " faces inside are selected";
  call.log(text.str());
  results["area"] = polygon.area;
  results["perimeter"] = polygon.perimeter;
  results["angles"] = as_vector(polygon.angles);
  results["curvature"] = polygon.curvature;
  results["gauss_bonnet"] = polygon.gauss_bonnet;
  results["vertices"] = as_vector(polygon.corners, [&](Index corner) { return corners.numbers[corner]; });
  results["selected_faces"] = static_cast<int>(polygon.faces.size());
  results["snap_distance"] = corners.snap_distance;
  return results;
}

// ---- Filter: bounds of the geodesic diameter and radius

RichParameterList extent_parameters(const MeshDocument&) {
  return list_of(RichInt("fields", 20, "Fields", "Distance fields that may be computed, at least 2."),
                 RichInt("vertex_index", -1, "Vertex",
                         "Number of a vertex of the component, counted from 0; -1: the largest component."),
                 exact_parameter());
}

Results measure_extent(FilterCall& call) {
  const int fields = number_of(call, "fields", 2, ". Give 2 or more.");
  const auto layer = layer_of(call);
  const int number = call.parameters.getInt("vertex_index");
  Index start = number == -1 ? no_index : vertex_of(call, *layer, "vertex_index");
  if (start == no_index) start = largest_component(*layer->mesh()).first_vertex;
  auto [extent, answered, results] =
      ask_task(call, *layer, "Diameter and centre", extent_of_component, start, fields);
  results["diameter_lower"] = extent.diameter.lower;
  results["diameter_upper"] = extent.diameter.upper;
  results["diameter_start"] = layer->host_vertex(extent.ends[0]);
  results["diameter_end"] = layer->host_vertex(extent.ends[1]);
  results["radius_lower"] = extent.radius.lower;
  results["radius_upper"] = extent.radius.upper;
  results["centre"] = layer->host_vertex(extent.centre);
  results["fields"] = extent.fields;
  call.log("Geodesic diameter between " + logged_length(extent.diameter.lower) + " and " +
           logged_length(extent.diameter.upper) + ", radius between " + logged_length(extent.radius.lower) +
           " and " + logged_length(extent.radius.upper) + " around vertex " +
           std::to_string(layer->host_vertex(extent.centre)));
  return results;
}

}  // namespace

std::vector<FilterRow> region_rows() {
  return {
      {"Geodesic Voronoi patches: colour faces (VoroGeo)", "compute_color_by_vorogeo_patches_per_face",
       "<p>Colours the faces by the geodesic Voronoi patches of the index, so that patches which share a "
       "vertex have clearly different colours. Faces that are in no patch (repeated faces, faces that name a "
       "vertex twice) become grey.</p><p>How to choose: <b>Layer</b> 1 has the large patches, layer 2 the "
       "small ones that they consist of, inside which distances are exact.</p><p>Returns the number of "
       "<i>patches</i> and of <i>colors</i>.</p>" +
           help_on_index() + references_of_index(),
       FilterPlugin::FaceColoring, MeshModel::MM_FACECOLOR, patch_colors_parameters, color_patches},
      {"Geodesic Voronoi regions of the selection: colour faces (VoroGeo)",
       "compute_color_by_vorogeo_voronoi_regions_per_face",
       "<p>Geodesic Voronoi regions: the parts of the surface that are nearer to one of the points than to "
       "the others. Faces are coloured by the region of their centre, neighbouring regions differently; the "
       "quality of each vertex is the number of its region, counted from 0, or -1 where no path leads.</p>"
       "<p><b>Borders</b> adds the borders of the regions as a polyline layer. They cross the faces where "
       "the distances from two points are equal, and meet where those from three are; on flat parts of the "
       "surface they are exact for the given distances. The current layer stays current.</p>"
       "<p>Returns the number of <i>regions</i>, their <i>areas</i>, the numbers of their points as "
       "<i>vertices</i>, the <i>border_length</i> and the <i>unreachable_vertices</i>.</p>" +
           help_on_task_points() + help_on_exact_parameter() + references_of_index(),
       FilterPlugin::FilterClass(FilterPlugin::FaceColoring | FilterPlugin::Quality),
       MeshModel::MM_VERTQUALITY | MeshModel::MM_FACECOLOR, voronoi_parameters, color_voronoi_regions},
      {"Cut locus of points (VoroGeo)", "generate_polyline_by_vorogeo_cut_locus",
       "<p>The places where several shortest paths from a point end, as a new polyline layer, which becomes "
       "the current one; the quality of its vertices is the distance from the point. Cut along these lines, "
       "the surface could be laid out from there by the directions of paths; across them, a picture laid "
       "onto it is torn. From several points, paths begin at the nearest one, and the lines are also the "
       "borders of their Voronoi regions.</p>" +
           help_on_task_points() +
           "<p>How to choose: a line begins at each vertex that is a convex corner, on a scan at every "
           "second one, and the directions of the paths on both sides of it hardly differ: <b>Least "
           "angle</b> leaves out the ends of lines up to where they differ by as much. 0 shows all lines. "
           "Exact, without an index.</p>"
           "<p>Returns the number of <i>segments</i>, their <i>length</i> and the number of "
           "<i>unreachable_vertices</i>. Without any line there is no layer. The mesh is not changed.</p>"
           "<p>See:<br/><i>Micha Sharir, Amir Schorr</i><br/><b>\"On shortest paths in polyhedral "
           "spaces\"</b><br/>SIAM Journal on Computing 15(1), 1986.</p>",
       FilterPlugin::Measure, MeshModel::MM_NONE, cut_locus_parameters, draw_cut_locus},
      {"Isolines of a geodesic distance (VoroGeo)", "generate_polyline_by_vorogeo_isolines",
       "<p>Lines on which the quality of the vertices has given values, as a new polyline layer, which "
       "becomes the current one; the quality of its vertices is the value of their line. Lines run straight "
       "through each face and continue across edges.</p><p>How to choose: the values are <b>Lines</b> evenly "
       "spaced ones between the least and the greatest quality, or those in <b>Values</b>, such as <tt>0.1 "
       "0.2 0.5</tt>. If <b>Quality is a distance</b> is ticked, vertices with negative quality (without a "
       "distance) have no lines at them, and an edge is crossed where the distance from a point of the plane "
       "would have the value, which is exact where the surface is flat: isolines there are circles. "
       "Otherwise any quality is interpolated linearly.</p><p>Returns the number of <i>segments</i>, their "
       "<i>length</i> and the <i>values</i>. First run one of the distance filters.</p>" +
           references_of_index(),
       FilterPlugin::Quality, MeshModel::MM_NONE, [](const MeshDocument&) { return level_parameters(10); },
       draw_isolines},
      {"Cut along isolines of a geodesic distance (VoroGeo)", "generate_splitting_by_vorogeo_isolines",
       "<p>Cuts the surface along the lines on which the quality of the vertices has given values: the parts "
       "between them become layers, of which the last is the current one. Faces are divided where a line "
       "crosses them, so borders follow the lines, and parts have the same points along a line. Vertices and "
       "faces keep colours, quality, normals and texture coordinates; at new vertices these are "
       "interpolated. The current layer is not changed.</p><p>How to choose: the values are <b>Lines</b> "
       "evenly spaced ones between the least and the greatest quality, or those in <b>Values</b>, such as "
       "<tt>0.1 0.2 0.5</tt>. If <b>Quality is a distance</b> is ticked, lines run as in <i>Isolines of a "
       "geodesic distance (VoroGeo)</i>, and faces at vertices with negative quality (without a distance) "
       "are a part of their own; otherwise any quality is interpolated linearly.</p><p>Returns the number of "
       "<i>parts</i>; for each of them, in <i>regions</i>, how many values are at most its quality, or -1 "
       "without a distance; and the <i>values</i>, in ascending order. First run one of the distance "
       "filters.</p>" +
           references_of_index(),
       FilterPlugin::FilterClass(FilterPlugin::Layer | FilterPlugin::Quality), MeshModel::MM_NONE,
       [](const MeshDocument&) { return level_parameters(1); }, cut_along_isolines},
      {"Cut along a curve (VoroGeo)", "generate_splitting_by_vorogeo_curve",
       "<p>Cuts the surface along a curve: the parts on its sides become layers, of which the last is the "
       "current one. Faces are divided where the curve crosses them, so borders follow it, and parts have "
       "the same points along it. Vertices and faces keep colours, quality, normals and texture coordinates; "
       "at new vertices these are interpolated. The current layer is not changed.</p>" +
           help_on_curve() +
           "<p>How to choose: the curve is one line that does not branch, closed or from border to border; "
           "shortest paths join its points, those of a layer without lines in their order. A curve that "
           "does not divide the surface is an error. Components that it does not touch are left out.</p>"
           "<p>Returns the number of <i>parts</i>, of the <i>faces</i> in each, and "
           "<i>snap_distance</i>.</p>" +
           references_of_index(),
       FilterPlugin::Layer, MeshModel::MM_NONE, curve_parameters, cut_along_curve},
      {"Select a geodesic disk (VoroGeo)", "compute_selection_by_vorogeo_geodesic_disk",
       "<p>Selects all vertices within the geodesic distance <b>Radius</b>, and the faces whose three "
       "vertices are. Distances are those from <b>Vertex</b> or, if this is -1, from the nearest of the "
       "selected vertices or of other points given: a selection grows by the radius over the surface, not "
       "through space. The previous selection is replaced.</p><p>Returns the numbers of "
       "<i>selected_vertices</i> and <i>selected_faces</i>.</p>" +
           help_on_task_points() + help_on_exact_parameter() + references_of_index(),
       FilterPlugin::Selection, MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT, disk_parameters,
       select_disk},
      {"Area of a geodesic disk (VoroGeo)", "get_vorogeo_area_of_geodesic_disk",
       "<p>The area of the surface within the geodesic distance <b>Radius</b> of <b>Vertex</b> or, if this "
       "is -1, of the nearest of the selected vertices or of other points given; and the length of its "
       "border, to which borders of the mesh do not count. Faces that the border crosses count in part, "
       "along its arcs, so that disks on flat parts of the surface have the area of circles. The mesh is not "
       "changed.</p><p>Returns <i>area</i> and <i>border_length</i>.</p>" +
           help_on_task_points() + help_on_exact_parameter() + references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, disk_parameters, measure_disk},
      {"Area of a band round a curve (VoroGeo)", "get_vorogeo_area_of_band",
       "<p>The area of the surface within the geodesic distance <b>Width</b> of a curve, on both sides of it "
       "and round its ends; and the length of its border, to which borders of the mesh do not count. Faces "
       "that the border crosses count in part. The mesh is not changed.</p>" +
           help_on_curve() +
           "<p>How to choose: the curve may be open, branch and be in several parts; shortest paths join the "
           "ends of its lines, and the points of a layer without lines. It counts as points at most "
           "<b>Spacing</b> apart: the border then has dents of at most spacing<sup>2</sup> / (8 width), and "
           "0 is a quarter of the typical edge.</p><p>Returns <i>area</i>, <i>border_length</i> and "
           "<i>snap_distance</i>.</p>" +
           help_on_exact_parameter() + references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, band_parameters, measure_band},
      {"Area of a region (VoroGeo)", "get_vorogeo_area_of_region",
       "<p>The area of a region and the length of its border, and if it has no border the volume that it "
       "encloses. The region is the selected faces of the layer or, if <b>Curve layer</b> is another one, "
       "the inside of the closed curve of that: the side without a border of the surface or, if both or none "
       "have one, the smaller one. Faces that the curve crosses count in part.</p><p>The points of the curve "
       "are moved to the nearest point of the surface; <i>snap_distance</i> is the farthest move, and one of "
       "more than <b>Max snap distance</b> is an error unless that is 0.</p><p>How to choose: the curve is "
       "one line that does not branch; shortest paths join its points, those of a layer without lines in "
       "their order, and the ends of an open one. It must not touch itself, and has to divide the surface. "
       "For several regions apply the filter once for each.</p><p>Returns <i>area</i>, <i>border_length</i> "
       "and <i>volume</i> (not a number where there is a border). The mesh is not changed.</p>" +
           references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, region_parameters, measure_region},
      {"Polygon of shortest paths (VoroGeo)", "generate_polyline_by_vorogeo_polygon",
       "<p>A polygon whose sides are the shortest paths from each point to the next, and from the last to "
       "the first: its area, perimeter and angles. The border is a new polyline layer, which becomes the "
       "current one; the quality of its vertices is the length up to there. The faces that are whole inside "
       "are selected, no others. With <b>Cut out</b>, the inside becomes a layer as well: faces are divided "
       "where the border crosses them, and keep colours, quality, normals and texture coordinates. With "
       "<b>Convex hull</b>, it is the shortest closed curve around the points: some of them are its corners, "
       "the <i>vertices</i> that are returned, and no angle is above half a turn.</p>" +
           help_on_task_points() +
           "<p>How to choose: give three points or more in an order in which no sides cross, by "
           "<b>Surface points</b> or a point layer: selected vertices come in the order of their numbers. "
           "The inside is the side without a border of the surface or, if both or none have one, the "
           "smaller one. Sides are exact; an index only makes them faster.</p><p>Returns <i>area</i>, "
           "<i>perimeter</i>, the <i>angles</i> at the points in radians, the <i>curvature</i> (sum of angle "
           "defects inside), <i>gauss_bonnet</i> (what is left of the theorem: 0 but for rounding) and "
           "<i>selected_faces</i>.</p>" +
           references_of_index(),
       FilterPlugin::FilterClass(FilterPlugin::Measure | FilterPlugin::Selection),
       MeshModel::MM_FACEFLAGSELECT, polygon_parameters, draw_polygon},
      {"Geodesic diameter and centre (VoroGeo)", "get_vorogeo_diameter_and_centre",
       "<p>Bounds of the geodesic diameter of a component (the greatest distance of two of its vertices) and "
       "of its radius (the least distance within which a vertex reaches all others). After a double sweep, "
       "further fields start where the ends or the centre may still be, and the triangle inequality bounds "
       "what no field started from. With enough <b>Fields</b> the bounds meet. They hold for the distances "
       "as computed: with <b>Exact</b>, for exact ones.</p><p>Returns <i>diameter_lower</i> and "
       "<i>diameter_upper</i>, the vertices <i>diameter_start</i> and <i>diameter_end</i> whose distance is "
       "the lower bound, <i>radius_lower</i>, <i>radius_upper</i>, the <i>centre</i> whose eccentricity is "
       "the upper bound, and the number of <i>fields</i> computed. The mesh is not changed.</p>" +
           help_on_exact_parameter() +
           "<p>See:<br/><i>Frank W. Takes, Walter A. Kosters</i><br/><b>\"Determining the diameter of small "
           "world networks\"</b><br/>CIKM 2011.</p>",
       FilterPlugin::Measure, MeshModel::MM_NONE, extent_parameters, measure_extent}};
}

}  // namespace vorogeo::plugin
