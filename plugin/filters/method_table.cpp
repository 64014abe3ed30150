// Filter: what geodesic methods cost, how far they err and what they claim, as a table.
#include <QFile>
#include <span>
#include <string>

#include "filters/rows.h"
#include "host/ticking.h"
#include "layers/parameters.h"
#include "methods/method_comparison.h"
#include "support/file.h"

namespace vorogeo::plugin {

namespace {

RichParameterList table_parameters(const MeshDocument&) {
  RichParameterList list;
  list.addParam(RichString(
      "methods", "all", "Methods",
      "Names with commas between, options in parentheses: vorogeo, svg(K=100), "
      "heat(delaunay=1). all: every method that works on this mesh, but ch, which is for small ones."));
  list.addParam(RichInt("sources", 3, "Sources",
                        "Vertices from which each method computes a field, evenly spaced by number."));
  list.addParam(RichFileToWrite("csv_file", "", "*.csv", "CSV file",
                                "File to write the table to. Empty: nothing is written."));
  return list;
}

template <class Value>
QVariant column(const std::vector<MethodMeasure>& measures, Value&& value) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(measures.size()));
  for (std::size_t i = 0; i < measures.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] = static_cast<double>(value(measures[i]));
  }
  return QVariant::fromValue(values);
}

Results measure_methods(FilterCall& call) {
  auto requests = parse_methods(call.parameters.getString("methods").toStdString());
  const int count = call.parameters.getInt("sources");
  if (count < 1) refuse(call, "sources", count, ". Give 1 or more.");
  const std::filesystem::path file =
      QFile::encodeName(call.parameters.getSaveFileName("csv_file")).toStdString();
  if (!file.empty()) output_target(file, "The CSV file");
  const LayerMesh layer_mesh(call);
  const auto mesh = read_mesh(call, layer_mesh);
  for (MethodRequest& request : requests) {
    request = with_gap(request, layer_mesh.gap());
    const auto& warning = method_named(request.name).warning;
    if (warning && !warning(*mesh).empty()) call.log(warning(*mesh));
  }
  const auto sources = spread_vertices(*mesh, count);
  const auto measures = run_ticking(call.progress, "Measuring geodesic methods", [&](const Progress& inner) {
    return compare_methods(mesh, requests, sources, inner);
  });
  call.log(comparison_text(measures));
  if (!file.empty()) {
    const std::string csv = comparison_csv(measures);
    OutputFile output(file, "The CSV file");
    output.write(std::as_bytes(std::span(csv)));
    output.finish();
  }
  using M = MethodMeasure;
  return {{"methods", static_cast<int>(measures.size())},
          {"sources", static_cast<int>(sources.size())},
          {"setup_seconds", column(measures, [](const M& m) { return m.setup_seconds; })},
          {"field_seconds", column(measures, [](const M& m) { return m.field_seconds; })},
          {"pair_seconds", column(measures, [](const M& m) { return m.pair_seconds; })},
          {"bytes", column(measures, [](const M& m) { return m.bytes; })},
          {"mean_error", column(measures, [](const M& m) { return m.mean_error; })},
          {"p99_error", column(measures, [](const M& m) { return m.p99_error; })},
          {"max_error", column(measures, [](const M& m) { return m.max_error; })}};
}

}  // namespace

FilterRow method_table_row() {
  return {
      "Table of geodesic methods (VoroGeo)",
      "get_geodesic_method_table",
      "<p>Runs the chosen geodesic methods of the literature on this mesh, from <b>Sources</b> vertices, and "
      "logs a table: what each claims (many sources, reuse, error bound, metrics, growth), then what was "
      "measured: set-up, field and pair times, memory, and errors against exact distances. The same goes to "
      "the <b>CSV file</b>.</p><p>Returns vectors in the order of the methods: <i>setup_seconds</i>, "
      "<i>field_seconds</i>, <i>pair_seconds</i> (not a number where two points cost a field), <i>bytes</i>, "
      "<i>mean_error</i>, <i>p99_error</i>, <i>max_error</i> (0.01 is 1 %).</p>"
      "<p>How to choose: a few sources tell the errors, more of them the mean times; on meshes of a million "
      "vertices name the methods, as <i>svg</i> and <i>dgg</i> take minutes there. For an error map of one "
      "method take <i>Compare geodesic methods (VoroGeo)</i>.</p>"
      "<p>See:<br/><i>Keenan Crane, Marco Livesu, Enrico Puppo, Yipeng Qin</i><br/><b>\"A survey of "
      "algorithms for geodesic paths and distances\"</b><br/>2020.</p>",
      FilterPlugin::Measure,
      MeshModel::MM_NONE,
      table_parameters,
      measure_methods,
      false};
}

}  // namespace vorogeo::plugin
