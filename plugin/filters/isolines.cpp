// Filter: lines of equal vertex quality as a polyline layer.
#include "tasks/surface_lines.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <string>

#include "filters/help.h"
#include "filters/rows.h"
#include "host/logged_length.h"
#include "layers/index_of_layer.h"
#include "layers/new_layer.h"
#include "layers/parameters.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

RichParameterList isolines_parameters(const MeshDocument&) {
  RichParameterList list;
  list.addParam(RichInt("line_number", 10, "Lines",
                        "Number of values, evenly spaced between the least and the greatest quality."));
  list.addParam(RichString("values", "", "Values",
                           "The values themselves, separated by spaces or semicolons; used if not empty."));
  list.addParam(RichBool("is_distance", true, "Quality is a distance",
                         "Negative quality means no distance, and lines cross edges as distances do."));
  return list;
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
  const int count = call.parameters.getInt("line_number");
  if (count < 1) {
    refuse(call, "line_number", count, ". Give 1 or more, or the values themselves.");
  }
  for (int i = 1; i <= count; ++i) values.push_back(low + (high - low) * i / (count + 1));
  return values;
}

Results draw_isolines(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  if (!call.layer.hasDataMask(MeshModel::MM_VERTQUALITY)) {
    throw InvalidInput("The vertices have no quality. Compute a distance first.");
  }
  const bool is_distance = call.parameters.getBool("is_distance");
  const auto mesh = read_mesh(call, layer_mesh);
  std::vector<double> field(static_cast<std::size_t>(mesh->given_vertex_count()));
  double low = unreachable;
  double high = -unreachable;
  for (Index v = 0; v < mesh->given_vertex_count(); ++v) {
    const double quality = call.layer.cm.vert[layer_mesh.host_vertex(v)].cQ();
    field[v] = is_distance && quality < 0.0 ? unreachable : quality;
    if (!std::isfinite(field[v])) continue;
    low = std::min(low, field[v]);
    high = std::max(high, field[v]);
  }
  if (low > high) {
    throw InvalidInput("No vertex has a quality that a line could be drawn for. Compute a distance first.");
  }
  const auto values = values_of(call, low, high);
  call.progress.report(0.0, "Isolines");
  const Isolines found =
      isolines(*mesh, field, values, is_distance ? Interpolation::distance : Interpolation::linear);
  std::vector<double> quality;
  for (Index level : found.level_of_point) quality.push_back(values[level]);
  call.progress.report(1.0, "Isolines");
  add_polyline_layer(call.document, call.layer, "Isolines", found.lines, quality, true);
  call.log("Isolines: " + std::to_string(found.lines.segments.size()) + " segments, " +
           logged_length(found.lines.length()) + " long in all");
  return {{"segments", static_cast<int>(found.lines.segments.size())},
          {"length", found.lines.length()},
          {"values", as_vector(values)}};
}

}  // namespace

FilterRow isolines_row() {
  return {
      "Isolines of a geodesic distance (VoroGeo)",
      "generate_polyline_by_vorogeo_isolines",
      "<p>Lines on which the quality of the vertices has given values, as a new polyline layer, which "
      "becomes the current one; the quality of its vertices is the value of their line. Lines run straight "
      "through each face and continue across edges.</p><p>How to choose: the values are <b>Lines</b> evenly "
      "spaced ones between the least and the greatest quality, or those in <b>Values</b>, such as <tt>0.1 "
      "0.2 0.5</tt>. If <b>Quality is a distance</b> is ticked, vertices with negative quality (without a "
      "distance) have no lines at them, and an edge is crossed where the distance from a point of the plane "
      "would have the value, which is exact where the surface is flat: isolines there are circles. Otherwise "
      "any quality is interpolated linearly.</p><p>Returns the number of <i>segments</i>, their "
      "<i>length</i> and the <i>values</i>. First run one of the distance filters.</p>" +
          references_of_index(),
      FilterPlugin::Quality,
      MeshModel::MM_NONE,
      isolines_parameters,
      draw_isolines};
}

}  // namespace vorogeo::plugin
