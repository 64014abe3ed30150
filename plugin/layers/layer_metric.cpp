// How a layer is measured: the parameters that choose a metric and bridge gaps, and the lengths they give.
#include "layers/layer_metric.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "layers/points.h"
#include "mesh/metric.h"
#include "mesh/one_way.h"
#include "mesh/vectors.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

void require_faces(const CMeshO& layer) {
  if (layer.vn == 0) {
    throw InvalidInput(
        "The current layer is empty: it has no vertices. Load or create a triangle mesh first.");
  }
  if (layer.fn == 0 && layer.en > 0) {
    throw InvalidInput(
        "The current layer has lines but no faces, and geodesic distances run over faces: make the layer of "
        "the surface the current one.");
  }
  if (layer.fn == 0) {
    throw InvalidInput(
        "The current layer is a point cloud: it has vertices but no faces, and geodesic distances run over "
        "faces. Reconstruct a surface from it first, for example by Screened Poisson.");
  }
}

constexpr const char* cost_attribute = "metric_cost";
constexpr const char* result_attribute = "metric_result";

using Attribute = CMeshO::PerVertexAttributeHandle<Scalarm>;

Attribute attribute(CMeshO& layer, const char* name) {
  return vcg::tri::Allocator<CMeshO>::FindPerVertexAttribute<Scalarm>(layer, name);
}

/// Whether the quality is what the last filter wrote over its cost. NaN, which is no cost, counts as equal.
bool is_result(CMeshO& layer, Attribute cost, Attribute result) {
  using Allocator = vcg::tri::Allocator<CMeshO>;
  if (!Allocator::IsValidHandle(layer, cost) || !Allocator::IsValidHandle(layer, result)) return false;
  return std::ranges::all_of(layer.vert, [&](const CVertexO& vertex) {
    return vertex.IsD() || vertex.cQ() == result[vertex] || std::isnan(vertex.cQ());
  });
}

/// The cost of each vertex of the host: its quality, or what it was before a filter wrote its result there.
std::vector<Scalarm> cost_of(const FilterCall& call, bool& is_kept) {
  CMeshO& layer = call.layer.cm;
  Attribute cost = attribute(layer, cost_attribute);
  is_kept = is_result(layer, cost, attribute(layer, result_attribute));
  std::vector<Scalarm> values;
  values.reserve(layer.vert.size());
  for (const CVertexO& vertex : layer.vert) values.push_back(is_kept ? cost[vertex] : vertex.cQ());
  return values;
}

/// A quality as a cost. \throw InvalidInput, naming the element by its number in the host.
double checked_cost(const FilterCall& call, const char* element, Index number, Scalarm quality) {
  const auto value = static_cast<double>(quality);
  if (value > 0.0) return value;
  const bool of_vertex = std::string(element) == "vertex";
  refuse(call, "metric", "the quality",
         ", but " + std::string(element) + " " + std::to_string(number) + " has quality " +
             std::to_string(value) +
             ". A cost is a number above 0: 2 makes paths count twice there, infinity bars them. Give all " +
             (of_vertex ? "vertices" : "faces") + " such a quality, for example with 'Per " +
             (of_vertex ? "Vertex" : "Face") + " Scalar Function'.");
}

/// The costs of the elements that are not deleted; quality_of(i): the quality of element i.
template <class Elements, class Quality>
std::vector<double> costs_of(const FilterCall& call, const char* element, const Elements& elements,
                             Quality&& quality_of) {
  std::vector<double> costs;
  costs.reserve(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i].IsD()) continue;
    costs.push_back(checked_cost(call, element, static_cast<Index>(i), quality_of(i)));
  }
  return costs;
}

std::vector<double> cost_of_faces(const FilterCall& call) {
  if (!call.layer.hasDataMask(MeshModel::MM_FACEQUALITY)) {
    throw InvalidInput(
        "The faces have no quality that could be the cost of paths. Compute one above 0, or choose another "
        "metric.");
  }
  const auto& faces = call.layer.cm.face;
  return costs_of(call, "face", faces, [&](std::size_t f) { return faces[f].cQ(); });
}

std::vector<double> cost_of_vertices(const FilterCall& call) {
  if (!call.layer.hasDataMask(MeshModel::MM_VERTQUALITY)) {
    throw InvalidInput(
        "The vertices have no quality that could be the cost of paths. Paint or compute one above 0, or "
        "choose another metric.");
  }
  bool is_kept = false;
  const std::vector<Scalarm> values = cost_of(call, is_kept);
  if (is_kept) {
    call.log(std::string("Metric: the quality is the result of the last filter; the cost is the one kept as "
                         "the vertex attribute ") +
             cost_attribute);
  }
  return costs_of(call, "vertex", call.layer.cm.vert, [&](std::size_t v) { return values[v]; });
}

constexpr const char* advice_from_0 = ". Give a number of at least 0.";

/// 0, any grade, in scripts without this parameter.
double steepest_grade(const FilterCall& call) {
  if (!call.parameters.hasParameter("steepest_grade")) return 0.0;
  return real_of(call, "steepest_grade", Values::from_0, ". Give a number above 0, or 0 for any grade.");
}

/// The wind in each face, in the scene: a custom attribute of the faces, or the mean of that of their
/// corners.
std::vector<Point> wind_of(const FilterCall& call, const Placement& placement) {
  CMeshO& layer = call.layer.cm;
  const std::string name = call.parameters.getString("wind_attribute").toStdString();
  using Allocator = vcg::tri::Allocator<CMeshO>;
  CMeshO::PerFaceAttributeHandle<Point3m> of_faces;
  CMeshO::PerVertexAttributeHandle<Point3m> of_vertices;
  if (!name.empty()) {  // the host takes an empty name for a mistake of the program
    of_faces = Allocator::FindPerFaceAttribute<Point3m>(layer, name);
    of_vertices = Allocator::FindPerVertexAttribute<Point3m>(layer, name);
  }
  const bool by_face = Allocator::IsValidHandle(layer, of_faces);
  if (!by_face && !Allocator::IsValidHandle(layer, of_vertices)) {
    refuse(
        call, "wind_attribute", "'" + name + "'",
        ", but neither the faces nor the vertices have a custom point attribute of this name. Make one, for "
        "example with 'Define New Per Face Custom Attribute'.");
  }
  const Point origin = placement.to_scene({});
  std::vector<Point> wind;
  for (const CFaceO& face : layer.face) {
    if (face.IsD()) continue;
    Point3m velocity = by_face ? of_faces[face] : Point3m(0, 0, 0);
    for (int i = 0; !by_face && i < 3; ++i) velocity += of_vertices[face.cV(i)] / 3;
    wind.push_back(minus(placement.to_scene({velocity[0], velocity[1], velocity[2]}), origin));
  }
  return wind;
}

/// These parameters are shown on request only: most questions are about lengths on the mesh as it is.
constexpr bool advanced = true;

/// No gap if the list lacks these parameters, as one from an older filter script does.
GapLimit gap_of(const FilterCall& call) {
  if (!call.parameters.hasParameter("gap")) return {};
  return {length_of(call, "gap", true),
          call.parameters.hasParameter("bridge_folds") && call.parameters.getBool("bridge_folds")};
}

/// Length in scripts without this parameter.
LayerMetric metric_of(const FilterCall& call) {
  if (!call.parameters.hasParameter("metric")) return LayerMetric::length;
  const int number = call.parameters.getEnum("metric");
  if (number < 0 || number > static_cast<int>(LayerMetric::wind)) {
    refuse(call, "metric", number,
           ". Give 0 for length, 1 for vertex quality as cost, 2 for a slope penalty, 3 for along curvature, "
           "4 for face quality as cost, 5 for hiking time, 6 for an uphill and downhill cost or 7 for wind.");
  }
  return static_cast<LayerMetric>(number);
}

/// Side lengths of the faces in a metric, and faces split for it; empty for length. With a cost for each
/// face, the faces of an edge disagree.
Metric metric_in(const LayerMeasure& measure, const VcgMeshArrays& arrays) {
  const auto& [positions, faces] = std::tie(arrays.positions, arrays.faces);
  const auto on_foot = [&](const CostOfGrade& pace) {
    Metric metric = metric_of(positions, faces, hiking_time(positions, faces, pace, {0, 0, 1}));
    if (measure.steepest > 0.0) {
      const auto grades = grades_of(positions, faces, {0, 0, 1});
      for (std::size_t f = 0; f < grades.size(); ++f) {
        if (grades[f] > measure.steepest) metric.sides[f].fill(unreachable);
      }
    }
    return metric;
  };
  switch (measure.metric) {
    case LayerMetric::length:
      break;
    case LayerMetric::vertex_quality:
      return lengths_by_cost(positions, faces, measure.cost);
    case LayerMetric::face_quality:
      return {sides_by_face_cost(positions, faces, measure.cost), usual_edge_points};
    case LayerMetric::slope:
      if (measure.steepest > 0.0) {
        std::vector<double> costs;
        for (const double grade : grades_of(positions, faces, {0, 0, 1})) {
          const bool is_barrier = grade > measure.steepest;
          costs.push_back(is_barrier ? unreachable : 1.0 + measure.weight * grade / std::hypot(1.0, grade));
        }
        return {sides_by_face_cost(positions, faces, costs), usual_edge_points};
      }
      return lengths_by_cost(positions, faces, slope_cost(positions, faces, {0, 0, 1}, measure.weight));
    case LayerMetric::curvature:
      return lengths_by_tensor(positions, faces, curvature_tensors(positions, faces, measure.weight));
    case LayerMetric::hiking:
      return on_foot(for_each_grade(tobler));
    case LayerMetric::climbing:
      return on_foot(climbing_cost(measure.weight, measure.downhill));
    case LayerMetric::wind:
      return metric_of(
          positions, faces,
          travel_time(positions, faces, measure.wind, std::vector(faces.size(), measure.weight)));
  }
  return {};
}

/// How many faces were split and edges shortened, one sentence each.
std::vector<std::string> remarks_on(const Metric& metric) {
  std::vector<std::string> remarks;
  if (metric.split_faces > 0) {
    remarks.push_back("Metric: " + std::to_string(metric.split_faces) +
                      " faces are measured in parts, as the metric varies over them; the mesh is coarse for "
                      "this metric");
  }
  if (metric.shortened_edges > 0) {
    remarks.push_back(
        "Metric: " + std::to_string(metric.shortened_edges) +
        " edges would cost more than the other two sides of a face together, and cost as much as these");
  }
  return remarks;
}

}  // namespace

RichParameterList metric_parameters() {
  QStringList metrics;
  for (const char* name : ruler_metrics) metrics << name;
  for (const char* name : one_way_metrics) metrics << name;
  const auto usual = [](LayerMetric metric) {
    return static_cast<Scalarm>(usual_weights[static_cast<std::size_t>(metric)]);
  };
  return list_of(
      RichEnum(
          "metric", static_cast<int>(LayerMetric::length), metrics, "Metric",
          "What paths cost: their length; the integral of the vertex quality, a cost above 0 for each unit "
          "of length, not a speed (where it is 2, paths count twice); more on slopes, for terrain; more "
          "across ridges and limbs than along them; or the quality of faces as a cost that jumps at edges, "
          "where paths refract. By the last three, a way back costs something else: seconds on foot by "
          "Tobler's hiking function if the unit is a metre; length and a cost for each unit of height, up "
          "and down; or time in a wind or current. These are answered exactly, without an index. An index "
          "belongs to its metric: newly painted quality is another metric. A "
          "filter that overwrites the quality keeps the cost as the vertex attribute metric_cost, so that it "
          "can be applied again.",
          advanced),
      RichFloat("slope_penalty", usual(LayerMetric::slope), "Slope penalty",
                "With the metric slope penalty: cost 1 on level ground and 1 plus this on a wall; z points "
                "upwards.",
                advanced),
      RichFloat(
          "steepest_grade", 0, "Steepest grade (0: any)",
          "With a slope penalty, on foot, and with costs up and down: no path enters faces that rise more "
          "than this for each unit of length on the map; 0.083 is 1 in 12.",
          advanced),
      RichFloat("curvature_weight", usual(LayerMetric::curvature), "Curvature weight",
                "With the metric along curvature: above 0, paths follow ridges and limbs; below 0, they run "
                "around them.",
                advanced),
      RichFloat("uphill_cost", 8, "Uphill cost",
                "With the metric uphill and downhill cost: what a unit of height costs besides the length of "
                "the way up; z points upwards. 8 is about Naismith's rule for hikers.",
                advanced),
      RichFloat("downhill_cost", 2, "Downhill cost", "The same on the way down.", advanced),
      RichString("wind_attribute", "wind", "Wind attribute",
                 "With the metric wind: the custom point attribute of the faces, or of the vertices, that is "
                 "the velocity of the wind or current.",
                 advanced),
      RichFloat("own_speed", 1, "Own speed",
                "With the metric wind: the speed of what moves in it, greater than that of the wind.",
                advanced));
}

RichBool direction_parameter() {
  return RichBool("to", false, "To the start",
                  "Measure by the ways to the points instead of from them; this differs only in a metric by "
                  "which a way back costs something else.",
                  advanced);
}

bool asks_for_paths_to(const FilterCall& call) {
  return call.parameters.hasParameter("to") && call.parameters.getBool("to");
}

RichParameterList gap_parameters(const MeshDocument& document) {
  return list_of(
      length_parameter(
          document, "gap", 0.0, "Bridge gaps up to (0: none)",
          "Borders at most this far apart that face each other, and equal positions, are joined in the mesh "
          "that is measured on; crossing a gap costs its width. The layer is not changed.",
          advanced),
      RichBool("bridge_folds", false, "Bridge folds",
               "Bridge also where the surface would turn back: rims side by side, sheets above each other.",
               advanced));
}

// Short: a dialog is as high as its help, and must leave room for its buttons on a small screen.
QString help_on_metric() {
  return "<p><b>Metric</b>: lengths, or a cost of paths; its tooltip explains.</p>";
}

LayerMeasure measure_of(const FilterCall& call) {
  require_faces(call.layer.cm);  // first, as costs do not matter without faces
  LayerMeasure measure;
  measure.placement = placement_of(call.layer);
  measure.gap = gap_of(call);
  measure.metric = metric_of(call);
  switch (measure.metric) {
    case LayerMetric::length:
      break;
    case LayerMetric::vertex_quality:
      measure.cost = cost_of_vertices(call);
      break;
    case LayerMetric::face_quality:
      measure.cost = cost_of_faces(call);
      break;
    case LayerMetric::slope:
      measure.weight = real_of(call, "slope_penalty", Values::from_0, advice_from_0);
      measure.steepest = steepest_grade(call);
      break;
    case LayerMetric::curvature:
      measure.weight = real_of(call, "curvature_weight", Values::all, ". Give a number.");
      break;
    case LayerMetric::hiking:
      measure.steepest = steepest_grade(call);
      break;
    case LayerMetric::climbing:
      measure.steepest = steepest_grade(call);
      measure.weight = real_of(call, "uphill_cost", Values::from_0, advice_from_0);
      measure.downhill = real_of(call, "downhill_cost", Values::from_0, advice_from_0);
      break;
    case LayerMetric::wind:
      measure.weight = real_of(call, "own_speed", Values::above_0, ". Give a number above 0.");
      measure.wind = wind_of(call, measure.placement);
      break;
  }
  return measure;
}

std::shared_ptr<LayerSurface> read_surface(const CMeshO& layer, LayerMeasure measure) {
  require_faces(layer);
  VcgMeshArrays arrays =
      arrays_from_vcg(layer, [&](const Point& at) { return measure.placement.to_scene(at); });
  arrays.metric = metric_in(measure, arrays);
  std::vector<std::string> remarks = remarks_on(arrays.metric);
  if (!measure.placement.is_identity()) {
    remarks.insert(remarks.begin(), "The layer's matrix was applied: lengths are those in the scene");
  }
  return std::make_shared<LayerSurface>(std::move(arrays), std::move(measure), std::move(remarks));
}

KeptCost::KeptCost(const FilterCall& call, const FilterRow& row) {
  const bool writes_quality = (row.changes & MeshModel::MM_VERTQUALITY) != 0;
  if (!row.has_metric || !writes_quality || metric_of(call) != LayerMetric::vertex_quality) return;
  bool is_kept = false;
  if (call.layer.hasDataMask(MeshModel::MM_VERTQUALITY)) cost_ = cost_of(call, is_kept);
}

void KeptCost::write(FilterCall& call) const {
  CMeshO& layer = call.layer.cm;
  if (cost_.empty() || cost_.size() != layer.vert.size()) return;
  using Allocator = vcg::tri::Allocator<CMeshO>;
  auto cost = Allocator::GetPerVertexAttribute<Scalarm>(layer, cost_attribute);
  auto result = Allocator::GetPerVertexAttribute<Scalarm>(layer, result_attribute);
  for (std::size_t v = 0; v < cost_.size(); ++v) {
    cost[v] = cost_[v];
    result[v] = layer.vert[v].cQ();
  }
}

}  // namespace vorogeo::plugin
