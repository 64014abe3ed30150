// Filter: colour the faces by the patches of one layer of the index.
#include <string>

#include "filters/help.h"
#include "filters/rows.h"
#include "layers/index_of_layer.h"
#include "layers/parameters.h"
#include "mesh/given_points.h"
#include "patches/partition.h"

namespace vorogeo::plugin {

namespace {

RichParameterList patch_colors_parameters(const MeshDocument&) {
  RichParameterList list;
  list.addParam(RichInt("layer", 1, "Layer", "Layer of patches: 1 (large patches) or 2 (small patches)."));
  return list;
}

/// Light grey: the colour of faces that are in no patch, because they repeat another face or name a vertex
/// twice.
vcg::Color4b color_without_patch() { return {160, 160, 160, 255}; }

Results color_patches(FilterCall& call) {
  const int layer = call.parameters.getInt("layer");
  if (layer != 1 && layer != 2) {
    refuse(call, "layer", layer, ". The index has two layers: give 1 (large patches) or 2 (small patches).");
  }
  const LayerMesh layer_mesh(call);
  const IndexOfLayer found = index_of_layer(call, layer_mesh);
  const Mesh& mesh = *found.index->mesh();
  const auto patches = found.index->face_patches(layer);
  const PatchColoring coloring = color_neighbors_differently(mesh, patches);
  call.progress.report(1.0, "Writing colours");

  call.layer.updateDataMask(MeshModel::MM_FACECOLOR);
  for (int face : layer_mesh.arrays().input_of_face) call.layer.cm.face[face].C() = color_without_patch();
  for (Index f : central_parts(mesh)) {
    const Rgb& color = coloring.palette[coloring.color_of_patch[patches[f]]];
    call.layer.cm.face[layer_mesh.host_face(mesh, f)].C() = {color[0], color[1], color[2], 255};
  }
  call.log("Patches of layer " + std::to_string(layer) + ": " +
           std::to_string(coloring.color_of_patch.size()) + ", in " + std::to_string(coloring.colors_used) +
           " colours");
  Results results = {{"patches", static_cast<int>(coloring.color_of_patch.size())},
                     {"colors", coloring.colors_used}};
  results.merge(about_index(found));
  return results;
}

}  // namespace

FilterRow patch_colors_row() {
  return {"Geodesic Voronoi patches: colour faces (VoroGeo)",
          "compute_color_by_vorogeo_patches_per_face",
          "<p>Colours the faces by the geodesic Voronoi patches of the index, so that patches which share a "
          "vertex have clearly different colours. Faces that are in no patch (repeated faces, faces that "
          "name a vertex twice) become grey.</p><p>How to choose: <b>Layer</b> 1 has the large patches, "
          "layer 2 the small ones that they consist of, inside which distances are exact.</p><p>Returns the "
          "number of <i>patches</i> and of <i>colors</i>.</p>" +
              help_on_index() + references_of_index(),
          FilterPlugin::FaceColoring,
          MeshModel::MM_FACECOLOR,
          patch_colors_parameters,
          color_patches};
}

}  // namespace vorogeo::plugin
