// Filters: describe the index of the current layer, save it to a file, load it from one.
#include <QFile>
#include <filesystem>
#include <sstream>
#include <string>

#include "filters/help.h"
#include "filters/index_file_name.h"
#include "filters/rows.h"
#include "host/ticking.h"
#include "layers/index_cache.h"
#include "layers/index_of_layer.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

namespace fs = std::filesystem;

RichParameterList no_parameters(const MeshDocument&) { return {}; }

RichParameterList file_to_write(const MeshDocument&) {
  RichParameterList list;
  list.addParam(
      RichFileToWrite("index_file", "", "*.vgi", "Index file", "File to write the index to, *.vgi."));
  return list;
}

RichParameterList file_to_read(const MeshDocument&) {
  RichParameterList list;
  list.addParam(RichFileToRead("index_file", "", {"*.vgi"}, "Index file",
                               "File that holds the index of exactly this mesh, *.vgi."));
  return list;
}

Results describe_index(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  call.progress.report(0.0, "Looking for the geodesic index");
  const auto index = call.indexes.find(layer_mesh.arrays(), layer_mesh.gap(), &call.document);
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
  const LayerMesh layer_mesh(call);
  const auto index = call.indexes.find(layer_mesh.arrays(), layer_mesh.gap(), &call.document);
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
  const LayerMesh layer_mesh(call);
  const auto index = run_ticking(call.progress, "Reading the geodesic index", [&](const Progress&) {
    return GeodesicIndex::load(file, layer_mesh.make_mesh());
  });
  call.indexes.put(layer_mesh.arrays(), layer_mesh.gap(), index, &call.document);
  call.log("Geodesic index: read from " + file.string());
  log_statistics(call, index->statistics());
  return statistics_results(index->statistics());
}

QString help_on_life() {
  return "<p>An index belongs to the mesh as it was when it was built: after an edit there is none until one "
         "is built or loaded. It is freed when the project is closed.</p>";
}

}  // namespace

FilterRow describe_index_row() {
  return {"Geodesic index: describe (VoroGeo)",
          "get_geodesic_index_by_vorogeo",
          "<p>Says in the log whether there is an index for the current mesh as it is, and its figures: "
          "vertices, patches, border vertices, arcs, size in memory and time of building. Builds nothing and "
          "changes nothing.</p>"
          "<p>How to choose: an index belongs to the metric and the gap it was built with.</p>" +
              help_on_life() + references_of_index(),
          FilterPlugin::Measure,
          MeshModel::MM_NONE,
          no_parameters,
          describe_index};
}

FilterRow save_index_row() {
  return {"Geodesic index: save to file (VoroGeo)",
          "save_geodesic_index_by_vorogeo",
          "<p>Writes the index of the current mesh to a file, from which <i>Geodesic index: load from file "
          "(VoroGeo)</i> and the Python package read it in a fraction of the time of building it. The mesh "
          "itself is not in the file. There must be an index: build one first.</p>"
          "<p>How to choose: let <b>Index file</b> end in <i>.vgi</i>: loading offers such files.</p>" +
              help_on_life() + references_of_index(),
          FilterPlugin::Measure,
          MeshModel::MM_NONE,
          file_to_write,
          save_index};
}

FilterRow load_index_row() {
  return {"Geodesic index: load from file (VoroGeo)",
          "load_geodesic_index_by_vorogeo",
          "<p>Reads an index from a file and keeps it for the current mesh, as if it had been built. The "
          "file must have been written for exactly this mesh, with the same vertices and faces in the same "
          "order; it is checked by a fingerprint, and refused otherwise. MeshLab's window holds coordinates "
          "in single precision and PyMeshLab in double precision: an index made by one fits the other if the "
          "mesh came from the same file with single-precision coordinates.</p>"
          "<p>How to choose: <b>Index file</b> is what <i>Geodesic index: save to file (VoroGeo)</i>, the "
          "build or the Python package wrote for this mesh.</p>" +
              help_on_life() + references_of_index(),
          FilterPlugin::Measure,
          MeshModel::MM_NONE,
          file_to_read,
          load_index};
}

}  // namespace vorogeo::plugin
