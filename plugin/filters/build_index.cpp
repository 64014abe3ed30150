// Filter: build the geodesic index of the current layer, and write it to a file if one is named.
#include <QFile>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <string>

#include "filters/help.h"
#include "filters/rows.h"
#include "index_cache.h"
#include "index_of_layer.h"
#include "layer_mesh.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

namespace fs = std::filesystem;

RichParameterList build_index_parameters(const MeshModel&) {
  RichParameterList list;
  list.addParam(
      RichInt("n1", 0, "First-layer patches",
              "Number of patches of the first layer. 0 chooses it from the number of vertices. More "
              "patches build faster and answer less accurately."));
  list.addParam(
      RichInt("n2", 0, "Second-layer patches",
              "Mean number of second-layer patches in one patch of the first layer. 0 chooses it."));
  list.addParam(RichFloat("delta", 0, "Delta",
                          "Relative average error that leaving out arcs may add, from 0 (loses nothing) to "
                          "below 1; 0.001 to 0.02 make the index smaller."));
  list.addParam(
      RichInt("memory_budget", 0, "Memory budget (MiB)",
              "Memory the index may take. If its tables fit, it is fast; if not, it is a graph that is "
              "searched, smaller and slower. 0: 4096 MiB."));
  list.addParam(RichFileToWrite("index_file", "", "*.vgi", "Index file",
                                "File to write the index to. Empty: the index is kept in memory only."));
  list.addParam(
      RichInt("threads", 0, "Threads", "Threads that build. 0: one per core. The index is the same."));
  list.addParam(RichInt("seed", 0, "Seed", "Start of the random numbers that place the patches."));
  return list;
}

/// More than any machine has cores; the core uses no more than it can feed.
constexpr int most_threads = 1024;

template <class Number>
[[noreturn]] void refuse(const std::string& name, Number value, const std::string& advice) {
  std::ostringstream text;
  text << name << " is " << value << ". " << advice;
  throw InvalidInput(text.str());
}

IndexOptions options_of(const RichParameterList& parameters) {
  const int n1 = parameters.getInt("n1");
  const int n2 = parameters.getInt("n2");
  const double delta = parameters.getFloat("delta");
  const int memory_budget = parameters.getInt("memory_budget");
  const int threads = parameters.getInt("threads");
  const int seed = parameters.getInt("seed");
  if (n1 < 0) refuse("n1", n1, "Give a positive number of patches, or 0 to have it chosen.");
  if (n2 < 0) refuse("n2", n2, "Give a positive number of patches, or 0 to have it chosen.");
  if (!(delta >= 0.0 && delta < 1.0)) refuse("delta", delta, "Give a number from 0 to below 1.");
  if (memory_budget < 0) {
    refuse("memory_budget", memory_budget, "Give a positive number of MiB, or 0 for 4096.");
  }
  if (threads < 0 || threads > most_threads) {
    refuse("threads", threads, "Give a number from 1 to 1024, or 0 for one per core.");
  }
  if (seed < 0) refuse("seed", seed, "Give 0 or a positive number.");
  IndexOptions options;
  options.first_layer_patches = n1;
  options.second_layer_patches = n2;
  options.delta = delta;
  options.threads = threads;
  options.seed = static_cast<std::uint64_t>(seed);
  options.memory_budget = memory_budget;
  return options;
}

/// Finds out before a long build whether the file can be written at all.
void check_index_file(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) {
    throw IndexFileError("The index file " + file.string() + " is a folder. Name a file in it.");
  }
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw IndexFileError("The index file " + file.string() + " cannot be written: there is no folder " +
                         folder.string() + ". Create it or name another file.");
  }
}

Results build_index_of_layer(FilterCall& call) {
  const IndexOptions options = options_of(call.parameters);
  const fs::path file = QFile::encodeName(call.parameters.getSaveFileName("index_file")).toStdString();
  if (!file.empty()) check_index_file(file);
  const LayerMesh layer_mesh(call.layer.cm);
  const auto index = build_index(call, layer_mesh, options, call.progress);
  if (!file.empty()) {
    index->save(file);
    call.log("Geodesic index: written to " + file.string());
  }
  call.indexes.put(layer_mesh.arrays(), index);

  // 64-bit counts go out as double: the host passes on int and double only, and double holds them exactly.
  const IndexStatistics& s = index->statistics();
  return {{"vertices", s.vertices},
          {"first_layer_patches", s.first_layer_patches},
          {"second_layer_patches", s.second_layer_patches},
          {"first_layer_border_vertices", s.first_layer_border_vertices},
          {"second_layer_border_vertices", s.second_layer_border_vertices},
          {"is_graph", s.form == IndexForm::graph ? 1 : 0},
          {"arcs_before_pruning", static_cast<double>(s.arcs_before_pruning)},
          {"arcs", static_cast<double>(s.arcs)},
          {"bytes", static_cast<double>(s.bytes)},
          {"seconds", s.seconds}};
}

}  // namespace

FilterRow build_index_row() {
  return {
      "Geodesic index: build (VoroGeo)",
      "compute_geodesic_index_by_vorogeo",
      "<p>Builds the index from which VoroGeo answers geodesic distances, and keeps it for this mesh: the "
      "other VoroGeo filters use it until the mesh is edited. The indexes of the four meshes used last are "
      "kept, as long as they take no more than 4 GiB together. The mesh is not changed.</p>"
      "<p>The surface is split into <b>n1</b> geodesic Voronoi patches, and each of them into about "
      "<b>n2</b> patches of a second layer. Exact distances inside the patches make a graph over the "
      "vertices on patch borders; arcs that others make superfluous are left out.</p>"
      "<p>How to choose: leave <b>n1</b> and <b>n2</b> at 0. Fewer, larger patches are a little more "
      "accurate "
      "and take longer to build. <b>memory_budget</b> chooses the form: tables, which answer fastest, "
      "or a pruned graph. <b>delta</b> = 0 leaves out nothing that matters; 0.001 to 0.02 ask for a graph "
      "and "
      "save memory at the cost of that much average relative error. <b>index_file</b> keeps the index for "
      "another program, which has to load the same mesh. <b>threads</b> does not influence the result; "
      "another <b>seed</b> places the patches differently.</p>"
      "<p>Returns and logs the number of vertices, of patches and border vertices of both layers, of arcs "
      "before and after pruning, whether the index is a graph (1) or tables (0), the size in bytes and the "
      "seconds it took.</p>" +
          references_of_index(),
      FilterPlugin::Measure,
      MeshModel::MM_NONE,
      build_index_parameters,
      build_index_of_layer};
}

}  // namespace vorogeo::plugin
