// Points that filters ask for: a start vertex, two ends, lists, the selection, another layer.
#include "layers/points.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "host/edit_host.h"
#include "layers/parameters.h"
#include "mesh/given_points.h"
#include "mesh/surface_locator.h"
#include "support/error.h"

namespace vorogeo::plugin {

// ---- Reads the selection of a layer

std::vector<Index> selected_vertices(const CMeshO& host_layer, const LayerSurface& layer,
                                     const char* purpose) {
  std::vector<Index> selected;
  for (std::size_t v = 0; v < layer.arrays().input_of_vertex.size(); ++v) {
    if (host_layer.vert[layer.host_vertex(static_cast<Index>(v))].IsS())
      selected.push_back(static_cast<Index>(v));
  }
  if (selected.empty()) {
    throw InvalidInput(std::string("No vertex is selected. Select the vertices ") + purpose +
                       "; a selection of faces can be turned into one with 'Select Vertices from Faces'.");
  }
  return selected;
}

// ---- Reads start_point and vertex_index

namespace {

/// The nearest vertex that has a face: no path reaches the others.
StartVertex nearest_vertex(const VcgMeshArrays& arrays, const Point& point) {
  std::vector<bool> has_face(arrays.positions.size(), false);
  for (const auto& face : arrays.faces) {
    for (Index v : face) has_face[v] = true;
  }
  StartVertex nearest;
  for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
    if (!has_face[v]) continue;
    const Point& p = arrays.positions[v];
    const double distance = std::hypot(p[0] - point[0], p[1] - point[1], p[2] - point[2]);
    if (distance < nearest.distance) nearest = {static_cast<Index>(v), distance};
  }
  return nearest;
}

/// The vertex that is named by number; no_index if the start point is used.
Index named_vertex(const FilterCall& call, const LayerSurface& layer) {
  const int number = call.parameters.getInt("vertex_index");
  return number == -1 ? no_index : vertex_of(call, layer, "vertex_index");
}

double straight(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

/// The corner of the point's face that the host has, if the point equals it up to the precision in which the
/// host passes points on.
SurfacePoint at_corner(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) return point;
  constexpr double precision = 1e-6;
  const Point at = position_of(mesh, point);
  double scale = 0.0;
  for (double coordinate : at) scale = std::max(scale, std::abs(coordinate));
  for (Index v : mesh.face_vertices(point.face)) {
    if (v < mesh.given_vertex_count() && straight(at, mesh.position(v)) <= precision * scale)
      return SurfacePoint::at_vertex(v);
  }
  return point;
}

}  // namespace

void add_start_vertex_parameters(RichParameterList& list, const MeshDocument& document,
                                 const QString& where) {
  list.addParam(RichPosition("start_point", document.mm()->cm.bbox.min, "Start point",
                             "Where distances start: at " + where +
                                 ". Choose 'Surf. Pos.' and press Get, then double-click on the surface. "
                                 "Used if the start vertex is -1."));
  list.addParam(
      RichInt("vertex_index", -1, "Start vertex",
              "Number of the vertex where distances start, counted from 0; -1: the start point is used."));
}

StartPoint start_point(const FilterCall& call, LayerSurface& layer) {
  const auto mesh = layer.mesh();
  std::ostringstream text;
  StartPoint start;
  const Index vertex = named_vertex(call, layer);
  if (vertex != no_index) {
    start.point = SurfacePoint::at_vertex(vertex);
  } else {
    const SnappedPoint found = layer.locator()->nearest(point_of(call, "start_point"));
    start = {at_corner(*mesh, found.point), found.distance};
  }
  if (const Index face = given_face_at(*mesh, start.point); face == no_index) {
    text << "Start: vertex " << layer.host_vertex(start.point.vertex);
  } else {
    text << "Start: a point in face " << layer.arrays().input_of_face[face];
  }
  if (vertex == no_index) text << ", " << logged_length(start.distance) << " away from the given point";
  call.log(text.str());
  return start;
}

StartVertex start_vertex(const FilterCall& call, const LayerSurface& layer) {
  const Index vertex = named_vertex(call, layer);
  const StartVertex start = vertex != no_index
                                ? StartVertex{vertex, 0.0}
                                : nearest_vertex(layer.arrays(), point_of(call, "start_point"));
  std::ostringstream text;
  text << "Start: vertex " << layer.host_vertex(start.vertex);
  if (vertex == no_index) text << ", " << logged_length(start.distance) << " away from the given point";
  call.log(text.str());
  return start;
}

// ---- Reads source, target, source_point, target_point and surface_points

namespace {

/// A vertex by its number, else the surface point nearest to a position.
SnappedPoint end_of(const FilterCall& call, LayerSurface& layer, const char* vertex, const char* point) {
  const int number = call.parameters.getInt(vertex);
  if (number != -1) return {SurfacePoint::at_vertex(vertex_of(call, layer, vertex)), 0.0};
  const SnappedPoint found = layer.locator()->nearest(point_of(call, point));
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

EndPoints end_points(const FilterCall& call, LayerSurface& layer) {
  const auto written = parse_surface_points(call, layer, "surface_points");
  if (written.size() == 2) return {{written[0], 0.0}, {written[1], 0.0}};
  if (!written.empty()) {
    throw InvalidInput(named(call, "surface_points") + " holds " + std::to_string(written.size()) +
                       " points. Give two, the source and the target, separated by a semicolon.");
  }
  return {end_of(call, layer, "source", "source_point"), end_of(call, layer, "target", "target_point")};
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

// ---- Reads point_layer, surface_points and the selection

namespace {

/// The point in a face of the host. \throw InvalidInput if there is none; `entry` begins the message.
SurfacePoint point_in_face(const LayerSurface& layer, const Mesh& mesh, int host_face,
                           const std::array<double, 3>& weights, const std::string& entry) {
  const auto& numbers = layer.arrays().input_of_face;  // ascending
  const auto found = std::ranges::lower_bound(numbers, host_face);
  const bool exists = found != numbers.end() && *found == host_face;
  const Index first = exists ? first_part(mesh, static_cast<Index>(found - numbers.begin())) : no_index;
  if (first != no_index) return validated(mesh, point_in_given(mesh, first, weights));
  throw InvalidInput(entry + " names face " + std::to_string(host_face) +
                     ", which the surface does not have. Faces are counted from 0; deleted ones and those "
                     "that name a vertex twice hold no points.");
}

/// One entry of the text. \throw InvalidInput.
SurfacePoint parse_point(const LayerSurface& layer, const Mesh& mesh, const QString& text,
                         const std::string& entry) {
  const QStringList words = text.split(' ', Qt::SkipEmptyParts);
  bool is_number = false;
  const int number = words.front().toInt(&is_number);
  std::array<double, 3> weights{};
  for (int i = 1; is_number && i < std::min(4, static_cast<int>(words.size())); ++i) {
    weights[i - 1] = words[i].toDouble(&is_number);
  }
  if (!is_number || (words.size() != 1 && words.size() != 4)) {
    throw InvalidInput(entry +
                       " is not a surface point. Give the number of a vertex, or the number of a face and "
                       "three weights, such as 17; 203 0.2 0.3 0.5.");
  }
  if (words.size() == 1) return SurfacePoint::at_vertex(layer.core_vertex(number, entry));
  try {
    return point_in_face(layer, mesh, number, weights, entry);
  } catch (const InvalidInput& error) {
    throw InvalidInput(entry + ": " + error.what());
  }
}

}  // namespace

std::vector<SurfacePoint> parse_surface_points(const FilterCall& call, LayerSurface& layer,
                                               const char* parameter) {
  const auto mesh = layer.mesh();
  std::vector<SurfacePoint> points;
  QString text = call.parameters.getString(parameter);
  const QStringList entries =
      text.replace(',', ' ').replace('\n', ';').replace('\t', ' ').split(';', Qt::SkipEmptyParts);
  for (const QString& entry : entries) {
    if (entry.trimmed().isEmpty()) continue;
    std::ostringstream name;
    name << '"' << entry.trimmed().toStdString() << "\", point " << points.size() << " of "
         << named(call, parameter) << ',';
    points.push_back(parse_point(layer, *mesh, entry, name.str()));
  }
  return points;
}

void add_task_point_parameters(RichParameterList& list, const MeshDocument& document, const char* what) {
  list.addParam(RichMesh("point_layer", static_cast<unsigned int>(document.mm()->id()), &document,
                         "Point layer",
                         QString("The layer with the %1: all its vertices, moved to the surface. The current "
                                 "layer: its selected vertices.")
                             .arg(what)));
  list.addParam(RichString("surface_points", "", "Surface points",
                           "Used instead if not empty: numbers of vertices, or of a face with three weights, "
                           "separated by semicolons, such as 17; 203 0.2 0.3 0.5."));
  list.addParam(max_snap_distance_parameter(document));
}

TaskPoints task_points(const FilterCall& call, LayerSurface& layer, const char* purpose) {
  TaskPoints result;
  if (!call.parameters.getString("surface_points").trimmed().isEmpty()) {
    const auto points = parse_surface_points(call, layer, "surface_points");
    for (std::size_t i = 0; i < points.size(); ++i) result.numbers.push_back(static_cast<int>(i));
    result.points = points;
    result.what = "surface points";
    if (points.empty()) throw InvalidInput(named(call, "surface_points") + " holds no point.");
    return result;
  }
  const auto id = static_cast<int>(call.parameters.getMeshId("point_layer"));
  if (id == static_cast<int>(call.layer.id())) {
    const auto vertices = selected_vertices(call.layer.cm, layer, purpose);
    for (Index v : vertices) result.numbers.push_back(layer.host_vertex(v));
    result.points = vertices;
    result.what = "selected vertices";
    return result;
  }
  SnappedLayer snapped = snapped_layer(call, layer, "point_layer", "points");
  result.points = snapped.points;
  result.numbers = std::move(snapped.numbers);
  result.snap_distance = snapped.snap_distance;
  result.what = "points of layer " + std::to_string(id);
  return result;
}

// ---- Reads layers of points and max_snap_distance

namespace {

/// A layer besides the current one, if there is one.
unsigned int some_other_layer(const MeshDocument& document) {
  for (const MeshModel& layer : document.meshIterator()) {
    if (&layer != document.mm()) return static_cast<unsigned int>(layer.id());
  }
  return static_cast<unsigned int>(document.mm()->id());
}

}  // namespace

void add_source_layer_parameter(RichParameterList& list, const MeshDocument& document, const char* what) {
  list.addParam(RichMesh("source_layer", some_other_layer(document), &document, "Source layer",
                         QString("The layer with the %1.").arg(what)));
}

const MeshModel& other_layer(const FilterCall& call, const char* parameter, const char* what) {
  const auto id = static_cast<int>(call.parameters.getMeshId(parameter));
  const MeshModel* other = call.document.getMesh(id);
  if (other == nullptr || other == &call.layer) {
    refuse(call, parameter, id,
           std::string(other == nullptr ? ", but there is no such layer." : ", the current layer itself.") +
               " Choose the layer with the " + what + ".");
  }
  return *other;
}

Point position_of(const CVertexO& vertex) {
  return {double(vertex.cP()[0]), double(vertex.cP()[1]), double(vertex.cP()[2])};
}

PointSnapper::PointSnapper(const FilterCall& call, LayerSurface& layer, const char* parameter)
    : locator_(layer.locator()),
      call_(call),
      parameter_(parameter),
      max_distance_(length_of(call, "max_snap_distance", true)) {}

SurfacePoint PointSnapper::snap(const Point& at, std::size_t number) {
  const SnappedPoint found = locator_->nearest(at);
  if (max_distance_ > 0.0 && found.distance > max_distance_) {
    std::ostringstream text;
    text << "Vertex " << number << " of layer " << call_.parameters.getMeshId(parameter_) << " is "
         << found.distance << " away from the surface, more than " << named(call_, "max_snap_distance")
         << ", " << max_distance_ << ". Move it or raise the limit.";
    throw InvalidInput(text.str());
  }
  farthest_ = std::max(farthest_, found.distance);
  return found.point;
}

SnappedLayer snapped_layer(const FilterCall& call, LayerSurface& surface, const char* parameter,
                           const char* what) {
  const CMeshO& layer = other_layer(call, parameter, what).cm;
  PointSnapper snapper(call, surface, parameter);
  SnappedLayer result;
  for (std::size_t v = 0; v < layer.vert.size(); ++v) {
    if (layer.vert[v].IsD()) continue;
    result.points.push_back(snapper.snap(position_of(layer.vert[v]), v));
    result.numbers.push_back(static_cast<int>(v));
  }
  result.snap_distance = snapper.farthest();
  if (result.points.empty()) {
    throw InvalidInput("Layer " + std::to_string(call.parameters.getMeshId(parameter)) +
                       " has no vertex. Choose a layer with " + what + ".");
  }
  return result;
}

}  // namespace vorogeo::plugin
