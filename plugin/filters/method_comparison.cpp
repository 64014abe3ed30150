// Filters that compare methods on the mesh, and list what they are.
#include "methods/method_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "filters/rows.h"
#include "host/host_methods.h"
#include "host/ticking.h"
#include "layers/answering.h"
#include "layers/points.h"
#include "layers/results.h"
#include "query/rent_or_buy.h"
#include "tasks/extent.h"

namespace vorogeo::plugin {

// ---- Filter: what geodesic methods cost, how far they err and what they claim, as a table

namespace {

RichParameterList table_parameters(const MeshDocument&) {
  return list_of(
      RichString(
          "methods", "all", "Methods",
          "Names with commas between, options in parentheses: vorogeo, svg(K=100), "
          "heat(delaunay=1). all: every method that works on this mesh, but ch, which is for small ones."),
      RichInt("sources", 3, "Sources",
              "Vertices from which each method computes a field, evenly spaced by number."),
      csv_file_parameter());
}

Results measure_methods(FilterCall& call) {
  auto requests = parse_methods(call.parameters.getString("methods").toStdString());
  const int count = number_of(call, "sources", 1, ". Give 1 or more.");
  const auto file = csv_file(call);
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  for (MethodRequest& request : requests) {
    request = with_gap(request, layer->gap());
    if (const std::string warning = warning_of(request.name, *mesh); !warning.empty()) call.log(warning);
  }
  const auto sources = spread_vertices(*mesh, count);
  const auto measures = run_ticking(call.progress, "Measuring geodesic methods", [&](const Progress& inner) {
    return compare_methods(mesh, requests, sources, inner);
  });
  call.log(comparison_text(measures));
  write_csv(call, file, comparison_csv(measures));
  using M = MethodMeasure;
  return {{"methods", static_cast<int>(measures.size())},
          {"sources", static_cast<int>(sources.size())},
          {"setup_seconds", as_vector(measures, &M::setup_seconds)},
          {"field_seconds", as_vector(measures, &M::field_seconds)},
          {"pair_seconds", as_vector(measures, &M::pair_seconds)},
          {"bytes", as_vector(measures, &M::bytes)},
          {"mean_error", as_vector(measures, &M::mean_error)},
          {"p99_error", as_vector(measures, &M::p99_error)},
          {"max_error", as_vector(measures, &M::max_error)}};
}

// ---- Filter: where and by how much two geodesic methods differ, from one source, as a signed error map

/// A field that a method is asked for.
struct FieldTask {
  FilterCall& call;
  LayerSurface& layer;
  Index source;
  Progress progress;
  std::string activity;
};

/// The field of the index, which is built if there is none, or the exact one.
MethodField surface_field(const FieldTask& task, Answer by) {
  FilterCall call = task.call;
  call.progress = task.progress;
  MethodField field;
  const auto ask = [&](Surface& surface, Answered& answered, const Progress& progress) {
    const Stopwatch preparing;
    if (by == Answer::exact) surface.geometry();
    field.build_seconds = preparing.seconds();
    const std::array sources{ExactSource{SurfacePoint::at_vertex(task.source)}};
    return surface.field(sources, unreachable, by, answered, progress).distance;
  };
  auto answer = ask_surface(call, task.layer, task.activity, ask);
  if (by == Answer::index) field.build_seconds = answer.answered.index_seconds;
  rest_if_large(task.layer, answer.answered, task.layer.mesh()->vertex_count());
  field.seconds = answer.answered.seconds;
  field.distances = std::move(answer.found);
  return field;
}

/// By one of MeshLab's own methods.
MethodField host_field(const FieldTask& task, MethodField (*method)(const Mesh&, Index)) {
  return run_ticking(task.progress, task.activity,
                     [&](const Progress&) { return method(*task.layer.mesh(), task.source); });
}

/// By a method of core/methods.
MethodField further_field(const FieldTask& task, const std::string& name) {
  const auto mesh = task.layer.mesh();
  if (const std::string warning = warning_of(name, *mesh); !warning.empty()) task.call.log(warning);
  const MethodRequest request = with_gap({name, {}}, task.layer.gap());
  return run_ticking(task.progress, task.activity, [&](const Progress& progress) {
    MethodField field;
    const Stopwatch preparing;
    const auto method = prepare_method(name, mesh, request.options, progress.part(0.0, 0.5));
    field.build_seconds = preparing.seconds();
    const Stopwatch running;
    field.distances = method->field(std::array{task.source}, progress.part(0.5, 1.0));
    field.seconds = running.seconds();
    return field;
  });
}

struct ComparedMethod {
  QString title;
  std::function<MethodField(const FieldTask&)> field;
};

/// In the order of the choices in the dialog; scripts hold their numbers. The first five are VoroGeo's or
/// MeshLab's own; then come the methods of core/methods, except those that are one of the five.
const std::vector<ComparedMethod>& compared_methods() {
  using Task = const FieldTask&;
  static const std::vector<ComparedMethod> methods = [] {
    std::vector<ComparedMethod> all{
        {"VoroGeo index", [](Task task) { return surface_field(task, Answer::index); }},
        {"Exact (VoroGeo)", [](Task task) { return surface_field(task, Answer::exact); }},
        {"Fast marching (MeshLab)", [](Task task) { return host_field(task, fast_marching_field); }},
        {"Heat method (MeshLab)", [](Task task) { return host_field(task, heat_field); }},
        {"Shortest edge path (Dijkstra)", [](Task task) { return host_field(task, edge_graph_field); }}};
    for (const MethodEntry& entry : all_methods()) {
      const std::string& name = entry.info.name;
      if (name == "vorogeo" || name == "mmp" || name == "dijkstra") continue;
      all.push_back({QString::fromStdString(entry.info.title),
                     [name](Task task) { return further_field(task, name); }});
    }
    return all;
  }();
  return methods;
}

RichParameterList comparison_parameters(const MeshDocument& document) {
  QStringList titles;
  for (const ComparedMethod& method : compared_methods()) titles.append(method.title);
  return list_of(start_parameters(document, "Where distances start: at the nearest vertex that has a face"),
                 RichEnum("method", 0, titles, "Method",
                          "The method that is judged. MeshLab 2022.02 has no heat method."),
                 RichEnum("reference", 1, titles, "Reference",
                          "The method it is compared with: differences are relative to its distances."));
}

const ComparedMethod& method_of(const FilterCall& call, const char* parameter) {
  const int number = call.parameters.getEnum(parameter);
  const auto& methods = compared_methods();
  if (number < 0 || static_cast<std::size_t>(number) >= methods.size()) {
    refuse(call, parameter, number,
           ". Give the number of a method, 0 to " + std::to_string(methods.size() - 1) + ".");
  }
  return methods[static_cast<std::size_t>(number)];
}

/// From blue (-1) over light grey (0) to red (1): the diverging map of Moreland, "Diverging color maps for
/// scientific visualization" (2009), between its end colours.
vcg::Color4b diverging_color(double t) {
  const vcg::Color4b negative(59, 76, 192, 255), middle(221, 221, 221, 255), positive(180, 4, 38, 255);
  vcg::Color4b color;
  color.lerp(middle, t < 0.0 ? negative : positive, static_cast<float>(std::min(1.0, std::abs(t))));
  return color;
}

void write_difference(FilterCall& call, const LayerSurface& layer, const FieldDifference& difference) {
  call.layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
  const double range = difference.p99 > 0.0 ? difference.p99 : 1.0;
  for (std::size_t v = 0; v < difference.relative.size(); ++v) {
    CVertexO& vertex = call.layer.cm.vert[layer.host_vertex(static_cast<Index>(v))];
    const double error = difference.relative[v];
    vertex.Q() = static_cast<Scalarm>(std::isnan(error) ? 0.0 : error);
    vertex.C() = std::isnan(error) ? grey() : diverging_color(error / range);
  }
}

void log_difference(FilterCall& call, const FieldDifference& d, const std::string& method,
                    const std::string& reference, const MethodField& a, const MethodField& b) {
  std::ostringstream text;
  text.precision(3);
  text << method << " against " << reference << ", " << d.compared << " vertices: mean " << 100 * d.mean
       << " %, RMS " << 100 * d.rms << " %, 99 % of them below " << 100 * d.p99 << " %, largest "
       << 100 * d.max << " %, mean with sign " << 100 * d.bias << " %";
  call.log(text.str());
  text.str("");
  text << "Time of the field: " << method << " " << a.seconds << " s (and once per mesh " << a.build_seconds
       << " s), " << reference << " " << b.seconds << " s (" << b.build_seconds << " s)";
  call.log(text.str());
  if (d.one_only > 0) {
    call.log("Distance by one method only: " + std::to_string(d.one_only) + " vertices, not compared");
  }
}

Results compare_methods(FilterCall& call) {
  const ComparedMethod& method = method_of(call, "method");
  const ComparedMethod& reference = method_of(call, "reference");
  const auto layer = layer_of(call);
  const Index start = start_vertex(call, *layer).point.vertex;
  const auto mesh = layer->mesh();
  const auto measured = [&](const ComparedMethod& which, const Progress& progress) {
    const std::string activity = "Geodesic distances: " + which.title.toStdString();
    progress.report(0.0, activity);
    MethodField field = which.field({call, *layer, mesh->representative(start), progress, activity});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      field.distances[v] = field.distances[mesh->representative(v)];
    }
    return field;
  };
  const MethodField b = measured(reference, call.progress.part(0.0, 0.5));
  const MethodField a = measured(method, call.progress.part(0.5, 1.0));
  const FieldDifference difference = difference_of(a.distances, b.distances);
  call.progress.report(1.0, "Writing quality and colours");
  write_difference(call, *layer, difference);
  log_difference(call, difference, method.title.toStdString(), reference.title.toStdString(), a, b);
  return {{"start_vertex", layer->host_vertex(start)},
          {"compared_vertices", difference.compared},
          {"vertices_by_one_method_only", difference.one_only},
          {"mean_error", difference.mean},
          {"mean_signed_error", difference.bias},
          {"rms_error", difference.rms},
          {"p99_error", difference.p99},
          {"max_error", difference.max},
          {"method_seconds", a.seconds},
          {"method_build_seconds", a.build_seconds},
          {"reference_seconds", b.seconds},
          {"reference_build_seconds", b.build_seconds}};
}

}  // namespace

std::vector<FilterRow> comparison_rows() {
  return {
      {"Compare geodesic methods (VoroGeo)", "compute_scalar_by_geodesic_method_comparison_per_vertex",
       "<p>Runs two geodesic methods from one vertex and writes (<b>Method</b> - <b>Reference</b>) / "
       "<b>Reference</b> into the vertex quality: 0.01 is one percent too long. Colours go from blue (too "
       "short) over light grey to red (too long) and are full at the 99th percentile; vertices with nothing "
       "to compare get 0 and grey. Mean, RMS, 99th percentile, largest difference and both times are "
       "logged.</p>"
       "<p>How to choose: keep the exact method as reference to see errors, or compare two approximate "
       "methods with each other. Fast marching, heat and Dijkstra are the code of this MeshLab, without a "
       "limit of distance; the methods after them are VoroGeo's code, with the usual options, which <i>Table "
       "of geodesic methods (VoroGeo)</i> can change; <i>Waves across gaps</i> takes <b>Bridge gaps up "
       "to</b> as its own gap.</p>"
       "<p>See:<br/><i>Marcin Novotni, Reinhard Klein</i><br/><b>\"Computing geodesic distances on "
       "triangular meshes\"</b><br/>WSCG 2002.<br/>"
       "<i>Keenan Crane, Clarisse Weischedel, Max Wardetzky</i><br/><b>\"Geodesics in heat\"</b><br/>ACM "
       "Transactions on Graphics 32(5), 2013.</p>",
       FilterPlugin::FilterClass(FilterPlugin::Quality | FilterPlugin::VertexColoring),
       MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR, comparison_parameters, compare_methods, false},
      {"Table of geodesic methods (VoroGeo)", "get_geodesic_method_table",
       "<p>Runs the chosen geodesic methods of the literature on this mesh, from <b>Sources</b> vertices, "
       "and logs a table: what each claims (many sources, reuse, error bound, metrics, growth), then what "
       "was measured: set-up, field and pair times, memory, and errors against exact distances. The same "
       "goes to the <b>CSV file</b>.</p><p>Returns vectors in the order of the methods: "
       "<i>setup_seconds</i>, <i>field_seconds</i>, <i>pair_seconds</i> (not a number where two points cost "
       "a field), <i>bytes</i>, <i>mean_error</i>, <i>p99_error</i>, <i>max_error</i> (0.01 is 1 %).</p>"
       "<p>How to choose: a few sources tell the errors, more of them the mean times; on meshes of a million "
       "vertices name the methods, as <i>svg</i> and <i>dgg</i> take minutes there. For an error map of one "
       "method take <i>Compare geodesic methods (VoroGeo)</i>.</p>"
       "<p>See:<br/><i>Keenan Crane, Marco Livesu, Enrico Puppo, Yipeng Qin</i><br/><b>\"A survey of "
       "algorithms for geodesic paths and distances\"</b><br/>2020.</p>",
       FilterPlugin::Measure, MeshModel::MM_NONE, table_parameters, measure_methods, false}};
}

}  // namespace vorogeo::plugin
