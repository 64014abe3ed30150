// From a filter call to what answers it: the surface of its layer, by the method that was chosen.
#include "layers/answering.h"

#include <iomanip>
#include <sstream>

#include "layers/layer_metric.h"
#include "layers/points.h"

namespace vorogeo::plugin {

// ---- Finds the layer in the cache, or reads it

std::shared_ptr<LayerSurface> layer_of(FilterCall& call) {
  LayerMeasure measure = measure_of(call);
  auto layer = call.layers.find(call.layer.cm, measure, &call.document);
  const bool is_new = layer == nullptr;
  if (is_new) layer = read_surface(call.layer.cm, std::move(measure));
  for (const std::string& remark : layer->remarks()) call.log(remark);
  if (!layer->has_surface()) {
    run_ticking(call.progress.part(0.0, 0.0), "Reading the mesh",
                [&](const Progress&) { return layer->surface(); });
  }
  if (is_new) call.layers.put(layer, &call.document);
  return layer;
}

void log_warnings(FilterCall& call, LayerSurface& layer) {
  const auto warnings =
      run_ticking(call.progress, "Checking the mesh", [&](const Progress&) { return layer.warnings(); });
  for (const std::string& warning : warnings) call.log("Mesh: " + layer.in_host_numbers(warning));
}

// ---- Builds indexes for filters and logs what was built

void log_statistics(const FilterCall& call, const IndexStatistics& s) {
  std::ostringstream text;
  text << "Geodesic index in the form of " << (s.form == IndexForm::graph ? "a graph" : "tables") << ": "
       << s.vertices << " vertices, " << s.first_layer_patches << " first-layer and "
       << s.second_layer_patches << " second-layer patches with " << s.first_layer_border_vertices << " and "
       << s.second_layer_border_vertices << " border vertices, " << s.arcs << " arcs ("
       << s.arcs_before_pruning << " before pruning), " << std::setprecision(3)
       << static_cast<double>(s.bytes) / (1 << 20) << " MiB";
  if (s.seconds > 0.0) text << ", built in " << s.seconds << " s";
  call.log(text.str());
}

// 64-bit counts are returned as double: the host passes on only int and double, and double holds them
// exactly.
Results statistics_results(const IndexStatistics& s) {
  return {{"vertices", s.vertices},
          {"first_layer_patches", s.first_layer_patches},
          {"second_layer_patches", s.second_layer_patches},
          {"first_layer_border_vertices", s.first_layer_border_vertices},
          {"second_layer_border_vertices", s.second_layer_border_vertices},
          {"is_graph", s.form == IndexForm::graph ? 1 : 0},
          {"arcs_before_pruning", static_cast<double>(s.arcs_before_pruning)},
          {"arcs", static_cast<double>(s.arcs)},
          {"bytes", static_cast<double>(s.bytes)},
          {"seconds", s.seconds},
          {"expected_fields", s.expected_fields}};
}

std::shared_ptr<const GeodesicIndex> build_index(FilterCall& call, LayerSurface& layer,
                                                 const IndexOptions& options, const Progress& progress,
                                                 const std::filesystem::path& file) {
  log_warnings(call, layer);
  const auto index = run_ticking(progress, "Reading the mesh", [&](const Progress& inner) {
    return file.empty() ? GeodesicIndex::build(layer.mesh(), options, inner)
                        : GeodesicIndex::build_in_file(file, layer.mesh(), options, inner);
  });
  log_statistics(call, index->statistics());
  layer.use(index);
  return index;
}

// ---- The method, and what is logged and returned about an answer

namespace {

/// Indexed by Answer.
constexpr const char* answered_by[] = {"", "the index", "exact propagation", "merged windows (quick)"};

/// Solvers are kept after answers that reach at most so many vertices.
constexpr Index max_vertices_kept = 1000000;

}  // namespace

void rest_if_large(LayerSurface& layer, const Answered& answered, Index vertices) {
  if (answered.by != Answer::index && vertices > max_vertices_kept) layer.rest();
}

RichEnum method_parameter() {
  QStringList names;
  for (const Answer method : {Answer::automatic, Answer::index, Answer::exact, Answer::quick}) {
    names.append(name_of(method));
  }
  return RichEnum("method", static_cast<int>(Answer::automatic), names, "Method",
                  "automatic: the index if this mesh has one, else exact answers, until these have taken as "
                  "long as building an index would; then it is built. index: builds it at once. exact: no "
                  "errors, no index. quick: a field with errors below a tenth of a percent in the mean, on "
                  "large meshes in a third to a tenth of the time.");
}

Answer method_of(const FilterCall& call) {
  const int number = call.parameters.getEnum("method");
  if (number < 0 || number > static_cast<int>(Answer::quick)) {
    refuse(call, "method", number, ". Give automatic, index, exact or quick, or its number from 0 to 3.");
  }
  return static_cast<Answer>(number);
}

Results about_answer(FilterCall& call, LayerSurface& layer, bool had_index, const Answered& answered) {
  if (!answered.remark.empty()) call.log(answered.remark);
  if (const auto index = layer.index(); index && !had_index) log_statistics(call, index->statistics());
  Results results = {{"answered_by", static_cast<int>(answered.by)}};
  std::string line = std::string("Answered by ") + answered_by[static_cast<int>(answered.by)];
  if (answered.by == Answer::index) {
    if (had_index) line += ": reused, the mesh has not changed since it was built";
    results["index_reused"] = had_index;
    results["index_seconds"] = answered.index_seconds;
  }
  call.log(line);
  return results;
}

}  // namespace vorogeo::plugin
