// What answers for a layer: its index or its surface, kept between calls, and the team of a task.
#include "layers/layer_surface.h"

#include <iomanip>
#include <sstream>

#include "host/ticking.h"
#include "layers/index_cache.h"
#include "layers/parameters.h"

namespace vorogeo::plugin {

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

Results about_index(const IndexOfLayer& found) {
  return {{"index_reused", found.reused},
          {"index_seconds", found.reused ? 0.0 : found.index->statistics().seconds}};
}

std::shared_ptr<const Mesh> read_mesh(const FilterCall& call, const LayerMesh& layer_mesh) {
  if (const auto index = call.indexes.find(layer_mesh.arrays(), layer_mesh.gap(), &call.document))
    return index->mesh();
  return run_ticking(call.progress.part(0.0, 0.0), "Reading the mesh",
                     [&](const Progress&) { return layer_mesh.make_mesh(); });
}

void log_warnings(FilterCall& call, const LayerMesh& layer_mesh) {
  const auto warnings =
      run_ticking(call.progress, "Checking the mesh", [&](const Progress&) { return layer_mesh.warnings(); });
  for (const std::string& warning : warnings) call.log("Mesh: " + warning);
}

std::shared_ptr<const GeodesicIndex> build_index(FilterCall& call, const LayerMesh& layer_mesh,
                                                 const IndexOptions& options, const Progress& progress,
                                                 const std::filesystem::path& file) {
  log_warnings(call, layer_mesh);
  const auto index = run_ticking(progress, "Reading the mesh", [&](const Progress& inner) {
    auto mesh = layer_mesh.make_mesh();
    return file.empty() ? GeodesicIndex::build(std::move(mesh), options, inner)
                        : GeodesicIndex::build_in_file(file, std::move(mesh), options, inner);
  });
  log_statistics(call, index->statistics());
  return index;
}

IndexOfLayer index_of_layer(FilterCall& call, const LayerMesh& layer_mesh) {
  if (auto index = call.indexes.find(layer_mesh.arrays(), layer_mesh.gap(), &call.document)) {
    call.log("Geodesic index: reused, the mesh has not changed since it was built");
    return {std::move(index), true};
  }
  auto index = build_index(call, layer_mesh, {}, call.progress.part(0.0, 0.9));
  call.indexes.put(layer_mesh.arrays(), layer_mesh.gap(), index, &call.document);
  return {std::move(index), false};
}

// ---- What is kept between calls goes into a Surface, and back after the answer

namespace {

/// By AnswerMethod.
constexpr const char* answered_by[] = {"", "the index", "exact propagation", "virtual sources (quick)"};

}  // namespace

RichEnum method_parameter() {
  QStringList names;
  for (const AnswerMethod method :
       {AnswerMethod::automatic, AnswerMethod::index, AnswerMethod::exact, AnswerMethod::quick}) {
    names.append(to_string(method));
  }
  return RichEnum(
      "method", static_cast<int>(AnswerMethod::automatic), names, "Method",
      "automatic: the index if this mesh has one, else exact answers, until these have taken as long as "
      "building an index would; then it is built. index: builds it at once. exact: no errors, no "
      "index. quick: a field with errors of some tenths of a percent in a tenth of the time.");
}

AnswerMethod method_of(const FilterCall& call) {
  const int number = call.parameters.getEnum("method");
  if (number < 0 || number > static_cast<int>(AnswerMethod::quick)) {
    refuse(call, "method", number, ". Give automatic, index, exact or quick, or its number from 0 to 3.");
  }
  return static_cast<AnswerMethod>(number);
}

SurfaceOfLayer::SurfaceOfLayer(FilterCall& call, const LayerMesh& layer_mesh,
                               std::shared_ptr<const Mesh> mesh)
    : call_(call), layer_mesh_(layer_mesh) {
  auto index = call.indexes.find(layer_mesh.arrays(), layer_mesh.gap(), &call.document);
  had_index_ = index != nullptr;
  if (had_index_) {
    mesh = index->mesh();
  } else {
    log_warnings(call, layer_mesh);
    if (!mesh) mesh = read_mesh(call, layer_mesh);
  }
  const RentOrBuy spent = call.indexes.spent(fingerprint_of(*mesh), mesh->vertex_count());
  surface_ = std::make_unique<Surface>(mesh, std::move(index), spent);
}

Results SurfaceOfLayer::finish(const Answered& answered) {
  call_.indexes.keep_spent(fingerprint_of(*mesh()), surface_->spent());
  if (!answered.remark.empty()) call_.log(answered.remark);
  if (const auto index = surface_->index(); index && !had_index_) {
    log_statistics(call_, index->statistics());
    call_.indexes.put(layer_mesh_.arrays(), layer_mesh_.gap(), index, &call_.document);
  }
  Results results = {{"answered_by", static_cast<int>(answered.by)}};
  std::string line = std::string("Answered by ") + answered_by[static_cast<int>(answered.by)];
  if (answered.by == AnswerMethod::index) {
    if (had_index_) line += ": reused, the mesh has not changed since it was built";
    results["index_reused"] = had_index_;
    results["index_seconds"] = answered.index_seconds;
  }
  call_.log(line);
  return results;
}

// ---- Takes the index from the cache or builds it, unless exact distances are wanted

TeamOfLayer team_of_layer(FilterCall& call, const LayerMesh& layer_mesh) {
  if (call.parameters.getBool("exact")) {
    log_warnings(call, layer_mesh);
    return {FieldTeam(read_mesh(call, layer_mesh)), call.progress, {}};
  }
  const IndexOfLayer found = index_of_layer(call, layer_mesh);
  return {FieldTeam(found.index), found.reused ? call.progress : call.progress.part(0.9, 1.0),
          about_index(found)};
}

}  // namespace vorogeo::plugin
