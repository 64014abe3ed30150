// Builds indexes for filters and logs what was built.
#include "layers/index_of_layer.h"

#include <iomanip>
#include <sstream>

#include "host/ticking.h"
#include "layers/index_cache.h"

namespace vorogeo::plugin {

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

}  // namespace vorogeo::plugin
