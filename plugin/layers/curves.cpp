// Curves that filters take: the lines of another layer, or selected edges.
#include "layers/curves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "support/lists.h"
#include "tasks/curve_sources.h"
#include "tasks/curves.h"
#include "tasks/path_through.h"
#include "tasks/surface_lines.h"

namespace vorogeo::plugin {

// ---- Edges of the surface, and points along lines

std::vector<std::array<Index, 2>> selected_edges(const FilterCall& call, const LayerSurface& layer,
                                                 const Mesh& mesh, const std::string& otherwise) {
  std::vector<std::array<Index, 2>> edges;
  for (Index f = 0; f < mesh.first_bridge(); ++f) {
    for (int i = 0; i < 3; ++i) {
      if (!call.layer.cm.face[layer.host_face(mesh, f)].IsFaceEdgeS(i)) continue;
      const auto [a, b] = std::minmax(mesh.given_corners(f)[i], mesh.given_corners(f)[(i + 1) % 3]);
      edges.push_back({a, b});
    }
  }
  sort_once(edges);
  if (edges.empty()) {
    throw InvalidInput("No edge is selected. Select edges, for example with 'Select Crease Edges', or " +
                       otherwise);
  }
  return edges;
}

RichLength spacing_parameter(const MeshDocument& document) {
  return length_parameter(
      document, "spacing", 0.0, "Spacing",
      "Distances start at points along lines at most this far apart; 0: a quarter of the typical edge.");
}

double spacing_of(const FilterCall& call, const Mesh& mesh) {
  const double spacing = length_of(call, "spacing", true);
  return spacing > 0.0 ? spacing : 0.25 * mesh.typical_edge_length();
}

CurveSources sources_of_layer(const FilterCall& call, LayerSurface& layer, const char* parameter,
                              double spacing, bool with_offsets) {
  const MeshModel& other = other_layer(call, parameter, "points or lines");
  const CMeshO& points = other.cm;
  const std::vector<Point> positions = scene_positions(other);
  PointSnapper snapper(call, layer);
  CurveSources curve;
  auto add = [&](const Point& at, double offset, std::size_t number) {
    curve.sources.push_back({snapper.snap_vertex(at, number, parameter), offset});
    curve.numbers.push_back(static_cast<Index>(number));
  };
  auto offset = [&](const CVertexO& v) { return with_offsets ? static_cast<double>(v.cQ()) : 0.0; };
  for (std::size_t v = 0; v < points.vert.size(); ++v) {
    if (!points.vert[v].IsD()) add(positions[v], offset(points.vert[v]), v);
  }
  for (const auto& edge : points.edge) {
    if (edge.IsD()) continue;
    const CVertexO& a = *edge.cV(0);
    const CVertexO& b = *edge.cV(1);
    const auto number = [&](const CVertexO& v) { return static_cast<std::size_t>(&v - points.vert.data()); };
    const auto between = points_between(positions[number(a)], positions[number(b)], spacing);
    for (std::size_t i = 0; i < between.size(); ++i) {
      const double t = static_cast<double>(i + 1) / static_cast<double>(between.size() + 1);
      add(between[i], std::lerp(offset(a), offset(b), t), number(t < 0.5 ? a : b));
    }
  }
  if (curve.sources.empty()) {
    throw InvalidInput("Layer " + std::to_string(call.parameters.getMeshId(parameter)) +
                       " has no vertex. Choose a layer with points or lines.");
  }
  curve.snap_distance = snapper.farthest();
  return curve;
}

// ---- Reads curve_layer

bool curve_is_selected(const FilterCall& call) {
  return static_cast<int>(call.parameters.getMeshId("curve_layer")) == static_cast<int>(call.layer.id());
}

std::vector<std::array<Index, 2>> selected_curve(const FilterCall& call, const LayerSurface& layer,
                                                 const Mesh& mesh) {
  return selected_edges(call, layer, mesh,
                        "choose a layer with lines as " + named(call, "curve_layer") + ".");
}

namespace {

std::string of_curve_layer(const FilterCall& call) {
  return curve_is_selected(call) ? ""
                                 : " of layer " + std::to_string(call.parameters.getMeshId("curve_layer"));
}

}  // namespace

RichParameterList curve_layer_parameters(const MeshDocument& document, const char* help) {
  return list_of(
      RichMesh("curve_layer", static_cast<unsigned int>(document.mm()->id()), &document, "Curve layer", help),
      max_snap_distance_parameter(document));
}

RichParameterList curve_parameters(const MeshDocument& document) {
  return curve_layer_parameters(document,
                                "The layer with the lines of the curve, which are moved to the surface. The "
                                "current layer: its selected edges.");
}

QString help_on_curve() {
  return "<p>The curve is the selected edges of the layer or, if <b>Curve layer</b> is another one, the "
         "lines of that, such as a path or a plane section: their points are moved to the nearest point of "
         "the surface; <i>snap_distance</i> is the farthest move, and one of more than <b>Max snap "
         "distance</b> "
         "is an error unless that is 0.</p>";
}

namespace {

/// The lines of another layer, on the surface.
struct LayerLines {
  std::vector<std::array<Index, 2>> edges;  ///< between vertices of the layer
  std::map<Index, SurfacePoint> points;     ///< by vertex of the layer
  double snap_distance = 0.0;
};

/// \throw InvalidInput if they have no length.
LayerLines lines_of_layer(const FilterCall& call, LayerSurface& layer, const MeshModel& other) {
  const std::vector<Point> positions = scene_positions(other);
  PointSnapper snapper(call, layer);
  LayerLines lines;
  // Ends of edges at one place are one point: a closed path ends at a vertex of its own.
  std::map<Point, Index> point_at;
  for (const auto& edge : other.cm.edge) {
    if (edge.IsD()) continue;
    std::array<Index, 2> ends{};
    for (int i = 0; i < 2; ++i) {
      const auto number = static_cast<Index>(edge.cV(i) - other.cm.vert.data());
      const Point& at = positions[number];
      const SurfacePoint point = snapper.snap_vertex(at, static_cast<std::size_t>(number), "curve_layer");
      ends[i] = point_at.emplace(at, number).first->second;
      lines.points.emplace(ends[i], point);
    }
    if (ends[0] != ends[1]) lines.edges.push_back(ends);
  }
  if (lines.edges.empty()) {
    throw InvalidInput("The lines" + of_curve_layer(call) + " have no length. Choose a layer with a curve.");
  }
  lines.snap_distance = snapper.farthest();
  return lines;
}

}  // namespace

CurveLegs legs_of_curve(const FilterCall& call, LayerSurface& layer) {
  const MeshModel& other = other_layer(call, "curve_layer", "lines of the curve");
  CurveLegs legs;
  if (other.cm.en == 0) {
    const TaskPoints curve = snapped_layer(call, layer, "curve_layer", "lines");
    for (std::size_t i = 0; i < curve.size(); ++i) {
      if (i + 1 == curve.size() && i > 0) break;  // a single point is a leg of its own
      const std::size_t next = std::min(i + 1, curve.size() - 1);
      legs.from.push_back(curve.points[i]);
      legs.to.push_back(curve.points[next]);
      legs.numbers.push_back({curve.numbers[i], curve.numbers[next]});
    }
    legs.snap_distance = curve.snap_distance;
    return legs;
  }
  const LayerLines lines = lines_of_layer(call, layer, other);
  for (const auto& [a, b] : lines.edges) {
    legs.from.push_back(lines.points.at(a));
    legs.to.push_back(lines.points.at(b));
  }
  legs.numbers = lines.edges;
  legs.snap_distance = lines.snap_distance;
  return legs;
}

std::vector<SurfacePoint> points_along(Surface& surface, const CurveLegs& legs, double spacing,
                                       const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  Answered answered;
  const auto paths =
      surface.paths({legs.from, legs.to}, options.by, {.exact = true}, answered, options.progress);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto& [a, b] = legs.numbers[i];
    if (paths[i].path.points.empty()) refuse_leg(mesh, a, legs.from[i], b, legs.to[i]);
    const auto steps = steps_along(mesh, paths[i].path.points, spacing);
    points.insert(points.end(), steps.begin(), steps.end());
  }
  return points;
}

std::vector<TaskPoints> curves_in_order(const FilterCall& call, LayerSurface& layer) {
  std::vector<TaskPoints> curves;
  if (curve_is_selected(call)) {
    const auto name = [&](Index v) { return "vertex " + std::to_string(layer.host_vertex(v)); };
    for (const auto& line : lines_in_order(selected_curve(call, layer, *layer.mesh()), name)) {
      TaskPoints& curve = curves.emplace_back();
      curve.points = line;
      for (const Index v : line) curve.numbers.push_back(layer.host_vertex(v));
      curve.what = "vertices of selected edges";
    }
    return curves;
  }
  const MeshModel& other = other_layer(call, "curve_layer", "lines of the curve");
  if (other.cm.en == 0) return {snapped_layer(call, layer, "curve_layer", "lines")};
  const LayerLines lines = lines_of_layer(call, layer, other);
  const std::string of_layer = of_curve_layer(call);
  const auto name = [&](Index v) { return "vertex " + std::to_string(v) + of_layer; };
  for (const auto& line : lines_in_order(lines.edges, name)) {
    TaskPoints& curve = curves.emplace_back();
    std::vector<SurfacePoint> points;
    for (const Index number : line) {
      points.push_back(lines.points.at(number));
      curve.numbers.push_back(number);
    }
    curve.points = points;
    curve.what = "points" + of_layer;
    curve.snap_distance = lines.snap_distance;
  }
  return curves;
}

TaskPoints curve_in_order(const FilterCall& call, LayerSurface& layer) {
  auto curves = curves_in_order(call, layer);
  if (curves.size() == 1) return std::move(curves[0]);
  const auto first = [&](std::size_t k) {
    return "vertex " + std::to_string(curves[k].numbers[0]) + of_curve_layer(call);
  };
  throw InvalidInput("The curve is in several parts: " + first(0) + " is on one of them, " + first(1) +
                     " on another. Leave one.");
}

std::vector<SurfacePoint> closed_line(Surface& surface, const TaskPoints& curve, const TaskOptions& options) {
  const bool ends_apart = curve.points[0] != curve.points[curve.size() - 1];
  return path_through(surface, curve.points, ends_apart, options).path.points;
}

// ---- Regions

RichParameterList region_parameters(const MeshDocument& document) {
  return curve_layer_parameters(
      document,
      "The layer with what bounds the region: closed curves, which are moved to the "
      "surface. The current layer: its selected faces are the region.");
}

std::vector<std::uint8_t> selected_region(const FilterCall& call, const LayerSurface& layer) {
  std::vector<std::uint8_t> region;
  for (const int face : layer.arrays().input_of_face) {
    region.push_back(call.layer.cm.face[face].IsS() ? 1 : 0);
  }
  if (std::ranges::find(region, 1) != region.end()) return region;
  throw InvalidInput(
      "No face is selected. Select the faces of a region, or choose a layer with a closed curve as " +
      named(call, "curve_layer") + ".");
}

}  // namespace vorogeo::plugin
