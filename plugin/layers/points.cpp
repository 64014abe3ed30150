// Labels and checks of parameters, and how points are read from them.
#include "layers/points.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "layers/results.h"
#include "mesh/mesh_input.h"
#include "mesh/surface_locator.h"
#include "support/error.h"

namespace vorogeo::plugin {

Placement placement_of(const MeshModel& layer) {
  std::array<std::array<double, 4>, 4> matrix{};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix[row][column] = static_cast<double>(layer.cm.Tr.ElementAt(row, column));
    }
  }
  const std::string label = layer.label().toStdString();  // PyMeshLab leaves it empty
  return {matrix, label.empty() ? "layer " + std::to_string(layer.id()) : "the layer \"" + label + "\""};
}

Box3m scene_box(const MeshModel& layer) {
  try {
    const Placement placement = placement_of(layer);
    if (placement.is_identity()) return layer.cm.bbox;
    Box3m box;
    for (const CVertexO& vertex : layer.cm.vert) {
      if (vertex.IsD()) continue;
      const Point at = placement.to_scene(position_of(vertex));
      box.Add(Point3m(static_cast<Scalarm>(at[0]), static_cast<Scalarm>(at[1]), static_cast<Scalarm>(at[2])));
    }
    return box;
  } catch (const InvalidInput&) {  // the matrix is refused once the layer is measured
    return layer.cm.bbox;
  }
}

std::string named(const FilterCall& call, const char* parameter) {
  // A list that was read from a filter script has names only.
  const std::string label =
      call.parameters.getParameterByName(parameter).fieldDescription().section(" (0:", 0, 0).toStdString();
  return label.empty() ? parameter : "\"" + label + "\" (" + parameter + ")";
}

RichLength length_parameter(const MeshDocument& document, const char* name, double share_of_diagonal,
                            const char* label, const char* tooltip, bool advanced) {
  const Scalarm diagonal = scene_box(*document.mm()).Diag();  // infinite if a coordinate is
  const Scalarm length = share_of_diagonal > 0.0 ? static_cast<Scalarm>(share_of_diagonal) * diagonal : 0;
  return RichLength(name, length, 0, diagonal, label, tooltip, advanced);
}

RichLength max_snap_distance_parameter(const MeshDocument& document) {
  return length_parameter(document, "max_snap_distance", 0.0, "Max snap distance (0: no limit)",
                          "How far a point may be from the surface; 0: any distance.");
}

double checked_value(const FilterCall& call, const char* parameter, double value, Values allowed,
                     const std::string& advice) {
  const bool is_allowed =
      allowed == Values::all || value > 0.0 || (allowed == Values::from_0 && value == 0.0);
  if (!std::isfinite(value) || !is_allowed) refuse(call, parameter, value, advice);
  return value;
}

double length_of(const FilterCall& call, const char* parameter, bool may_be_zero) {
  return checked_value(call, parameter, call.parameters.getAbsPerc(parameter),
                       may_be_zero ? Values::from_0 : Values::above_0,
                       std::string(". Give a length ") + (may_be_zero ? "of 0 or more" : "above 0") +
                           " in the unit of the mesh or in percent.");
}

double real_of(const FilterCall& call, const char* parameter, Values allowed, const char* advice) {
  return checked_value(call, parameter, call.parameters.getFloat(parameter), allowed, advice);
}

int number_of(const FilterCall& call, const char* parameter, int least, const char* advice, int greatest) {
  const int number = call.parameters.getInt(parameter);
  if (number < least || number > greatest) refuse(call, parameter, number, advice);
  return number;
}

RichBool exact_parameter() {
  return RichBool("exact", false, "Exact",
                  "Exact propagation for each point, also where the index is faster: without its errors.");
}

RichInt seed_parameter(bool advanced) {
  return RichInt("seed", 0, "Seed", "Seed of the random numbers.", advanced);
}

std::uint64_t seed_of(const FilterCall& call) {
  return static_cast<std::uint64_t>(number_of(call, "seed", 0, ". Give 0 or a positive number."));
}

Index vertex_of(const FilterCall& call, const LayerSurface& layer, const char* parameter) {
  return layer.core_vertex(call.parameters.getInt(parameter), named(call, parameter));
}

Point point_of(const FilterCall& call, const char* parameter) {
  const Point3m given = call.parameters.getPoint3m(parameter);
  const Point point{double(given[0]), double(given[1]), double(given[2])};
  for (double coordinate : point) {
    if (!std::isfinite(coordinate)) {
      throw InvalidInput(named(call, parameter) +
                         " has a coordinate that is NaN or infinite. Give three finite coordinates, or the "
                         "number of a vertex.");
    }
  }
  return point;
}

// ---- Reads the selection of a layer

std::vector<Index> selected_vertices(const FilterCall& call, const LayerSurface& layer, const char* purpose) {
  std::vector<Index> selected;
  for (Index v = 0; v < static_cast<Index>(layer.arrays().input_of_vertex.size()); ++v) {
    if (call.layer.cm.vert[layer.host_vertex(v)].IsS()) selected.push_back(v);
  }
  if (selected.empty()) {
    throw InvalidInput(std::string("No vertex is selected. Select the vertices ") + purpose +
                       "; a selection of faces can be turned into one with 'Select Vertices from Faces'.");
  }
  return selected;
}

// ---- Reads start_point and vertex_index

namespace {

/// The nearest vertex that has a face.
SnappedPoint nearest_vertex(const VcgMeshArrays& arrays, const Point& point) {
  SnappedPoint nearest{{}, unreachable};
  for (const auto& face : arrays.faces) {
    for (Index v : face) {
      const double distance = distance_between(arrays.positions[v], point);
      const bool is_first_of_equals = distance == nearest.distance && v < nearest.point.vertex;
      if (distance < nearest.distance || is_first_of_equals) nearest = {SurfacePoint::at_vertex(v), distance};
    }
  }
  return nearest;
}

/// The corner that a point equals in the precision in which the host passes points on, of those that the host
/// has; the point itself if there is none.
SurfacePoint at_corner(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) return point;
  constexpr double precision = 1e-6;
  const Point at = position_of(mesh, point);
  double scale = 0.0;
  for (double coordinate : at) scale = std::max(scale, std::abs(coordinate));
  for (Index v : mesh.face_vertices(point.face)) {
    if (v < mesh.given_vertex_count() && distance_between(at, mesh.position(v)) <= precision * scale)
      return SurfacePoint::at_vertex(v);
  }
  return point;
}

/// The vertex that is named by number, otherwise nearest(start_point); logs which.
template <class Nearest>
SnappedPoint start_of(const FilterCall& call, const LayerSurface& layer, const Mesh& mesh, Nearest nearest) {
  const bool is_named = call.parameters.getInt("vertex_index") != -1;
  const SnappedPoint start =
      is_named ? SnappedPoint{SurfacePoint::at_vertex(vertex_of(call, layer, "vertex_index"))}
               : nearest(point_of(call, "start_point"));
  const HostPlace place = layer.host_place(mesh, start.point);
  std::ostringstream text;
  text << "Start: " << (place.face < 0 ? "vertex " : "a point in face ")
       << std::max(place.vertex, place.face);
  if (!is_named) text << ", " << logged_length(start.distance) << " away from the given point";
  call.log(text.str());
  return start;
}

}  // namespace

RichParameterList start_parameters(const MeshDocument& document, const QString& what) {
  return list_of(
      RichPosition("start_point", scene_box(*document.mm()).min, "Start point",
                   what +
                       ". Choose 'Surf. Pos.' and press Get, then double-click on the surface. Used if the "
                       "start vertex is -1."),
      RichInt("vertex_index", -1, "Start vertex",
              "Number of a vertex instead, counted from 0; -1: the start point is used."));
}

SnappedPoint start_point(const FilterCall& call, LayerSurface& layer) {
  const auto mesh = layer.mesh();
  return start_of(call, layer, *mesh, [&](const Point& given) {
    const SnappedPoint found = layer.locator()->nearest(given);
    return SnappedPoint{at_corner(*mesh, found.point), found.distance};
  });
}

Results about_start(const LayerSurface& layer, const Mesh& mesh, const SnappedPoint& start) {
  const HostPlace place = layer.host_place(mesh, start.point);
  return {{"start_vertex", place.vertex}, {"start_face", place.face}, {"snap_distance", start.distance}};
}

SnappedPoint start_vertex(const FilterCall& call, LayerSurface& layer) {
  return start_of(call, layer, *layer.mesh(),
                  [&](const Point& given) { return nearest_vertex(layer.arrays(), given); });
}

// ---- Reads surface_points

namespace {

/// The point in a face of the host, whose weights are not checked. \throw InvalidInput if there is no such
/// face; `entry` begins the message.
SurfacePoint point_in_face(const LayerSurface& layer, const Mesh& mesh, int host_face,
                           const std::array<double, 3>& weights, const std::string& entry) {
  const auto& numbers = layer.arrays().input_of_face;  // ascending
  const auto found = std::ranges::lower_bound(numbers, host_face);
  const bool exists = found != numbers.end() && *found == host_face;
  const Index face = exists ? static_cast<Index>(found - numbers.begin()) : no_index;
  if (const auto point = InputMap(mesh).in_face(face, weights)) return *point;
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
  const SurfacePoint point = point_in_face(layer, mesh, number, weights, entry);
  try {
    return validated(mesh, point);
  } catch (const InvalidInput& error) {
    throw InvalidInput(entry.substr(0, entry.rfind(',')) + ": " + error.what());
  }
}

/// Surface points written as text, separated by semicolons: a vertex as its number, any other point as the
/// number of a face and three weights. All numbers are the host's. \throw InvalidInput that names the entry.
std::vector<SurfacePoint> written_points(const FilterCall& call, LayerSurface& layer) {
  const auto mesh = layer.mesh();
  std::vector<SurfacePoint> points;
  QString text = call.parameters.getString("surface_points");
  const QStringList entries =
      text.replace(',', ' ').replace('\n', ';').replace('\t', ' ').split(';', Qt::SkipEmptyParts);
  for (const QString& entry : entries) {
    if (entry.trimmed().isEmpty()) continue;
    std::ostringstream name;
    name << '"' << entry.trimmed().toStdString() << "\", point " << points.size() << " of "
         << named(call, "surface_points") << ',';
    points.push_back(parse_point(layer, *mesh, entry, name.str()));
  }
  return points;
}

}  // namespace

// ---- Reads source, target, source_point, target_point and surface_points

namespace {

/// A vertex by its number, else the surface point nearest to a position.
SnappedPoint end_of(const FilterCall& call, LayerSurface& layer, const char* vertex, const char* point) {
  const int number = call.parameters.getInt(vertex);
  if (number != -1) return {SurfacePoint::at_vertex(vertex_of(call, layer, vertex)), 0.0};
  const Point at = point_of(call, point);
  const auto name = [&] { return named(call, point); };
  return PointSnapper(call, layer).snap(at, name, "the point");
}

}  // namespace

RichParameterList end_point_parameters(const MeshDocument& document, int vertex) {
  return list_of(
      RichInt("source", vertex, "Source vertex", "Number of the first vertex, counted from 0; -1: a point."),
      RichInt("target", vertex, "Target vertex", "Number of the second vertex, counted from 0; -1: a point."),
      RichPosition(
          "source_point", scene_box(*document.mm()).min, "Source point",
          "Used if the source vertex is -1: the nearest point of the surface. Choose 'Surf. Pos.' and press "
          "Get, then double-click on the surface."),
      RichPosition("target_point", scene_box(*document.mm()).max, "Target point",
                   "Used if the target vertex is -1: the nearest point of the surface."),
      max_snap_distance_parameter(document),
      RichString(
          "surface_points", "", "Surface points",
          "Used instead of all these if not empty: source and target, each the number of a vertex, or of a "
          "face with three weights, such as 17; 203 0.2 0.3 0.5."));
}

EndPoints end_points(const FilterCall& call, LayerSurface& layer) {
  const auto written = written_points(call, layer);
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

// ---- Reads point_layer and the selection

RichParameterList task_point_parameters(const MeshDocument& document, const char* what) {
  return list_of(
      RichMesh(
          "point_layer", static_cast<unsigned int>(document.mm()->id()), &document, "Point layer",
          QString("The layer with the %1: all its vertices, moved to the surface. The current layer: its "
                  "selected vertices.")
              .arg(what)),
      RichString(
          "surface_points", "", "Surface points",
          "Used instead if not empty: numbers of vertices, or of a face with three weights, separated by "
          "semicolons, such as 17; 203 0.2 0.3 0.5."),
      max_snap_distance_parameter(document));
}

TaskPoints task_points(const FilterCall& call, LayerSurface& layer, const char* purpose) {
  TaskPoints result;
  if (!call.parameters.getString("surface_points").trimmed().isEmpty()) {
    result.points = written_points(call, layer);
    if (result.points.empty()) throw InvalidInput(named(call, "surface_points") + " holds no point.");
    result.numbers.resize(result.size());
    std::iota(result.numbers.begin(), result.numbers.end(), 0);
    result.what = "surface points";
    return result;
  }
  if (static_cast<int>(call.parameters.getMeshId("point_layer")) != static_cast<int>(call.layer.id())) {
    return snapped_layer(call, layer, "point_layer", "points");
  }
  const auto vertices = selected_vertices(call, layer, purpose);
  for (Index v : vertices) result.numbers.push_back(layer.host_vertex(v));
  result.points = vertices;
  result.what = "selected vertices";
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

RichMesh source_layer_parameter(const MeshDocument& document, const char* what) {
  return RichMesh("source_layer", some_other_layer(document), &document, "Source layer",
                  QString("The layer with the %1.").arg(what));
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

std::vector<Point> scene_positions(const MeshModel& layer) {
  const Placement placement = placement_of(layer);
  std::vector<Point> positions;
  for (const CVertexO& vertex : layer.cm.vert) positions.push_back(placement.to_scene(position_of(vertex)));
  return positions;
}

PointSnapper::PointSnapper(const FilterCall& call, LayerSurface& layer)
    : call_(call), locator_(layer.locator()), max_distance_(length_of(call, "max_snap_distance", true)) {}

SnappedPoint PointSnapper::snap(const Point& at, const std::function<std::string()>& name, const char* it) {
  SnappedPoint found;
  try {
    found = locator_->nearest(at);
  } catch (const InvalidInput& error) {
    throw InvalidInput(name() + ": " + error.what());
  }
  if (max_distance_ > 0.0 && found.distance > max_distance_) {
    std::ostringstream text;
    text << name() << " is " << found.distance << " away from the surface, more than "
         << named(call_, "max_snap_distance") << ", " << max_distance_ << ". Move " << it
         << " or raise the limit.";
    throw InvalidInput(text.str());
  }
  farthest_ = std::max(farthest_, found.distance);
  return found;
}

SurfacePoint PointSnapper::snap_vertex(const Point& at, std::size_t number, const char* parameter) {
  const auto name = [&] {
    return "Vertex " + std::to_string(number) + " of layer " +
           std::to_string(call_.parameters.getMeshId(parameter));
  };
  return snap(at, name, "it").point;
}

TaskPoints snapped_layer(const FilterCall& call, LayerSurface& surface, const char* parameter,
                         const char* what) {
  const MeshModel& other = other_layer(call, parameter, what);
  const CMeshO& layer = other.cm;
  const std::vector<Point> positions = scene_positions(other);
  const std::string id = std::to_string(call.parameters.getMeshId(parameter));
  PointSnapper snapper(call, surface);
  std::vector<SurfacePoint> points;
  TaskPoints result;
  for (std::size_t v = 0; v < layer.vert.size(); ++v) {
    if (layer.vert[v].IsD()) continue;
    points.push_back(snapper.snap_vertex(positions[v], v, parameter));
    result.numbers.push_back(static_cast<int>(v));
  }
  if (points.empty()) throw InvalidInput("Layer " + id + " has no vertex. Choose a layer with " + what + ".");
  result.points = points;
  result.what = "points of layer " + id;
  result.snap_distance = snapper.farthest();
  return result;
}

}  // namespace vorogeo::plugin
