// Reads point_layer, surface_points and the selection.
#include "layers/task_points.h"

#include <QStringList>
#include <algorithm>
#include <sstream>

#include "layers/index_of_layer.h"
#include "layers/parameters.h"
#include "layers/selected_vertices.h"
#include "layers/source_layer.h"
#include "mesh/given_points.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

/// The point in a face of the host. \throw InvalidInput if there is none; `entry` begins the message.
SurfacePoint point_in_face(const LayerMesh& layer_mesh, const Mesh& mesh, int host_face,
                           const std::array<double, 3>& weights, const std::string& entry) {
  const auto& numbers = layer_mesh.arrays().input_of_face;  // ascending
  const auto found = std::ranges::lower_bound(numbers, host_face);
  const bool exists = found != numbers.end() && *found == host_face;
  const Index first = exists ? first_part(mesh, static_cast<Index>(found - numbers.begin())) : no_index;
  if (first != no_index) return validated(mesh, point_in_given(mesh, first, weights));
  throw InvalidInput(entry + " names face " + std::to_string(host_face) +
                     ", which the surface does not have. Faces are counted from 0; deleted ones and those "
                     "that name a vertex twice hold no points.");
}

/// One entry of the text. \throw InvalidInput.
SurfacePoint parse_point(const LayerMesh& layer_mesh, const Mesh& mesh, const QString& text,
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
  if (words.size() == 1) return SurfacePoint::at_vertex(layer_mesh.core_vertex(number, entry));
  try {
    return point_in_face(layer_mesh, mesh, number, weights, entry);
  } catch (const InvalidInput& error) {
    throw InvalidInput(entry + ": " + error.what());
  }
}

}  // namespace

std::vector<SurfacePoint> parse_surface_points(const FilterCall& call, const LayerMesh& layer_mesh,
                                               const Mesh& mesh, const char* parameter) {
  std::vector<SurfacePoint> points;
  QString text = call.parameters.getString(parameter);
  const QStringList entries =
      text.replace(',', ' ').replace('\n', ';').replace('\t', ' ').split(';', Qt::SkipEmptyParts);
  for (const QString& entry : entries) {
    if (entry.trimmed().isEmpty()) continue;
    std::ostringstream name;
    name << '"' << entry.trimmed().toStdString() << "\", point " << points.size() << " of "
         << named(call, parameter) << ',';
    points.push_back(parse_point(layer_mesh, mesh, entry, name.str()));
  }
  return points;
}

void add_task_point_parameters(RichParameterList& list, const MeshDocument& document, const char* what,
                               bool with_snap_distance) {
  list.addParam(RichMesh("point_layer", static_cast<unsigned int>(document.mm()->id()), &document,
                         "Point layer",
                         QString("The layer with the %1: all its vertices, moved to the surface. The current "
                                 "layer: its selected vertices.")
                             .arg(what)));
  list.addParam(RichString("surface_points", "", "Surface points",
                           "Used instead if not empty: numbers of vertices, or of a face with three weights, "
                           "separated by semicolons, such as 17; 203 0.2 0.3 0.5."));
  if (with_snap_distance) list.addParam(max_snap_distance_parameter(document));
}

TaskPoints task_points(const FilterCall& call, const LayerMesh& layer_mesh, const char* purpose) {
  TaskPoints result;
  if (!call.parameters.getString("surface_points").trimmed().isEmpty()) {
    const auto mesh = read_mesh(call, layer_mesh);
    const auto points = parse_surface_points(call, layer_mesh, *mesh, "surface_points");
    for (std::size_t i = 0; i < points.size(); ++i) result.numbers.push_back(static_cast<int>(i));
    result.points = points;
    result.what = "surface points";
    if (points.empty()) throw InvalidInput(named(call, "surface_points") + " holds no point.");
    return result;
  }
  const auto id = static_cast<int>(call.parameters.getMeshId("point_layer"));
  if (id == static_cast<int>(call.layer.id())) {
    const auto vertices = selected_vertices(call.layer.cm, layer_mesh, purpose);
    for (Index v : vertices) result.numbers.push_back(layer_mesh.host_vertex(v));
    result.points = vertices;
    result.what = "selected vertices";
    return result;
  }
  SnappedLayer layer = snapped_layer(call, read_mesh(call, layer_mesh), "point_layer", "points");
  result.points = layer.points;
  result.numbers = std::move(layer.numbers);
  result.snap_distance = layer.snap_distance;
  result.what = "points of layer " + std::to_string(id);
  return result;
}

}  // namespace vorogeo::plugin
