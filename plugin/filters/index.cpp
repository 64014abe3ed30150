// Filters for the index: build, describe, save and load.
#include <QFile>
#include <filesystem>
#include <sstream>

#include "filters/rows.h"
#include "host/ticking.h"
#include "layers/answering.h"
#include "layers/points.h"
#include "support/error.h"
#include "support/file.h"

namespace vorogeo::plugin {

// ---- Reads and checks names of index files

namespace {

namespace fs = std::filesystem;

/// The path in the system's encoding; empty if no file was named.
fs::path index_file_name(const QString& name) { return QFile::encodeName(name).toStdString(); }

/// Checks before a long build that the file can be written at all. \throw Error if not.
void check_index_file_can_be_written(const fs::path& file) {
  if (file.empty()) throw IndexFileError("No index file is named. Name one that ends in .vgi.");
  output_target(file, "The index file");
}

// ---- Filter: build the geodesic index of the current layer, and write it to a file if one is named

/// The window shows the parameter on request only; such parameters are the last of a dialog.
constexpr bool advanced = true;

RichParameterList build_index_parameters(const MeshDocument&) {
  return list_of(
      RichInt("n1", 0, "First-layer patches (0: chosen)",
              "Number of patches of the first layer. 0 chooses it from the number of vertices. "
              "More patches build faster and answer less accurately."),
      RichInt("n2", 0, "Second-layer patches (0: chosen)",
              "Mean number of second-layer patches in one patch of the first layer. 0 chooses it."),
      RichFileToWrite("index_file", "", "*.vgi", "Index file",
                      "File to write the index to. Empty: the index is kept in memory only. In a new "
                      "file the index is built table by table, so it may be larger than the memory, "
                      "and a build that is stopped goes on from there the next time."),
      RichFloat("delta", 0, "Delta",
                "Average relative error that leaving out arcs may add, from 0 (loses nothing) to "
                "below 1; 0.001 to 0.02 make the index smaller.",
                advanced),
      RichInt("memory_budget", 0, "Memory budget (MiB)",
              "Memory the index may take. If its tables fit, it is fast; if not, it is a graph "
              "that is searched, smaller and slower. 0: 4096 MiB, and no limit for tables in a "
              "new index file.",
              advanced),
      RichInt("threads", 0, "Threads (0: one per core)",
              "Threads of the build. The index does not depend on their number.", advanced),
      seed_parameter(advanced));
}

/// More than the cores of any machine; the core starts no more threads than are useful.
constexpr int max_threads = 1024;

IndexOptions options_of(const FilterCall& call) {
  constexpr const char* patches = ". Give a positive number of patches, or 0 to have it chosen.";
  IndexOptions options;
  options.first_layer_patches = number_of(call, "n1", 0, patches);
  options.second_layer_patches = number_of(call, "n2", 0, patches);
  options.delta = call.parameters.getFloat("delta");
  if (!(options.delta >= 0.0 && options.delta < 1.0)) {
    refuse(call, "delta", options.delta, ". Give a number from 0 to below 1.");
  }
  options.memory_budget =
      number_of(call, "memory_budget", 0, ". Give a positive number of MiB, or 0 for 4096.");
  options.threads =
      number_of(call, "threads", 0, ". Give a number from 1 to 1024, or 0 for one per core.", max_threads);
  options.seed = seed_of(call);
  return options;
}

Results build_index_of_layer(FilterCall& call) {
  const IndexOptions options = options_of(call);
  const fs::path file = index_file_name(call.parameters.getSaveFileName("index_file"));
  if (!file.empty()) check_index_file_can_be_written(file);
  const auto layer = layer_of(call);
  // A file that exists is replaced, but only by an index that is complete.
  std::error_code unknown;  // check_index_file_can_be_written() has looked
  const bool in_file = !file.empty() && !fs::exists(file, unknown);
  const auto index = build_index(call, *layer, options, call.progress, in_file ? file : fs::path());
  if (!file.empty() && !in_file) {
    run_ticking(call.progress.part(1.0, 1.0), "Writing the geodesic index",
                [&](const Progress&) { index->save(file); });
  }
  if (!file.empty()) call.log("Geodesic index: written to " + file.string());

  return statistics_results(index->statistics());
}

// ---- Filters: describe the index of the current layer, save it to a file, load it from one

RichParameterList no_parameters(const MeshDocument&) { return {}; }

RichParameterList file_to_write(const MeshDocument&) {
  return list_of(
      RichFileToWrite("index_file", "", "*.vgi", "Index file", "File to write the index to, *.vgi."));
}

RichParameterList file_to_read(const MeshDocument&) {
  return list_of(RichFileToRead("index_file", "", {"*.vgi"}, "Index file",
                                "File that holds the index of exactly this mesh, *.vgi."));
}

Results describe_index(FilterCall& call) {
  const auto layer = layer_of(call);
  call.progress.report(0.0, "Looking for the geodesic index");
  const auto index = layer->index();
  if (!index) {
    call.log(
        "Geodesic index: none for this mesh as it is. 'Geodesic index: build (VoroGeo)' builds one; other "
        "VoroGeo filters do so when they need it.");
    return {{"has_index", false}};
  }
  const IndexStatistics& s = index->statistics();
  log_statistics(call, s);
  Results results = statistics_results(s);
  results["has_index"] = true;
  return results;
}

Results save_index(FilterCall& call) {
  const fs::path file = index_file_name(call.parameters.getSaveFileName("index_file"));
  check_index_file_can_be_written(file);
  const auto layer = layer_of(call);
  const auto index = layer->index();
  if (!index) {
    throw InvalidInput(
        "There is no index for this mesh as it is. Run 'Geodesic index: build (VoroGeo)' first.");
  }
  run_ticking(call.progress, "Writing the geodesic index", [&](const Progress&) { index->save(file); });
  const auto bytes = static_cast<double>(fs::file_size(file));
  std::ostringstream text;
  text.precision(3);
  text << "Geodesic index: written to " << file.string() << ", " << bytes / (1 << 20) << " MiB";
  call.log(text.str());
  return {{"file_bytes", bytes}};
}

Results load_index(FilterCall& call) {
  const fs::path file = index_file_name(call.parameters.getOpenFileName("index_file"));
  if (file.empty()) throw IndexFileError("No index file is named. Name one that ends in .vgi.");
  const auto layer = layer_of(call);
  const auto index = run_ticking(call.progress, "Reading the geodesic index",
                                 [&](const Progress&) { return GeodesicIndex::load(file, layer->mesh()); });
  layer->use(index);
  call.log("Geodesic index: read from " + file.string());
  log_statistics(call, index->statistics());
  return statistics_results(index->statistics());
}

QString help_on_life() {
  return "<p>An index belongs to the mesh as it was when it was built: after an edit there is none until one "
         "is built or loaded. It is freed when the project is closed.</p>";
}

}  // namespace

std::vector<FilterRow> index_rows() {
  return {{"Geodesic index: build (VoroGeo)", "compute_geodesic_index_by_vorogeo",
           "<p>Builds the index from which VoroGeo answers geodesic distances: the surface is split into two "
           "layers of geodesic Voronoi patches, and exact distances inside them make a graph over the patch "
           "borders. It is kept for this mesh, and the other VoroGeo filters use it until the mesh is edited "
           "or the project is closed. Its figures are logged and returned.</p>"
           "<p>How to choose: leave the numbers of patches at 0; fewer, larger patches are a little more "
           "accurate and take longer to build. <b>Memory budget</b> chooses the form: tables, which answer "
           "fastest, or a pruned graph. <b>Delta</b> 0 leaves out nothing that matters; 0.001 to 0.02 save "
           "memory at the cost of that much average relative error. An <b>index file</b> keeps the index for "
           "later, for the same mesh.</p>" +
               references_of_index(),
           FilterPlugin::Measure, MeshModel::MM_NONE, build_index_parameters, build_index_of_layer},
          {"Geodesic index: describe (VoroGeo)", "get_geodesic_index_by_vorogeo",
           "<p>Says in the log whether there is an index for the current mesh as it is, and its figures: "
           "vertices, patches, border vertices, arcs, size in memory and time of building. Builds nothing "
           "and changes nothing.</p>"
           "<p>How to choose: an index belongs to the metric and the gap it was built with.</p>" +
               help_on_life() + references_of_index(),
           FilterPlugin::Measure, MeshModel::MM_NONE, no_parameters, describe_index},
          {"Geodesic index: save to file (VoroGeo)", "save_geodesic_index_by_vorogeo",
           "<p>Writes the index of the current mesh to a file, from which <i>Geodesic index: load from file "
           "(VoroGeo)</i> and the Python package read it in a fraction of the time of building it. The mesh "
           "itself is not in the file. There must be an index: build one first.</p>"
           "<p>How to choose: let <b>Index file</b> end in <i>.vgi</i>: loading offers such files.</p>" +
               help_on_life() + references_of_index(),
           FilterPlugin::Measure, MeshModel::MM_NONE, file_to_write, save_index},
          {"Geodesic index: load from file (VoroGeo)", "load_geodesic_index_by_vorogeo",
           "<p>Reads an index from a file and keeps it for the current mesh, as if it had been built. The "
           "file must have been written for exactly this mesh, with the same vertices and faces in the same "
           "order; it is checked by a fingerprint, and refused otherwise. MeshLab's window holds coordinates "
           "in single precision and PyMeshLab in double precision: an index made by one fits the other if "
           "the mesh came from the same file with single-precision coordinates.</p>"
           "<p>How to choose: <b>Index file</b> is what <i>Geodesic index: save to file (VoroGeo)</i>, the "
           "build or the Python package wrote for this mesh.</p>" +
               help_on_life() + references_of_index(),
           FilterPlugin::Measure, MeshModel::MM_NONE, file_to_read, load_index}};
}

}  // namespace vorogeo::plugin
