// What follows from the layout of both layers together.
#include "index/index_data.h"

#include "patches/halo.h"
#include "support/progress.h"

namespace vorogeo {

void IndexData::link_layers() {
  parent_column.assign(second.border.element.size(), no_index);
  std::vector<Index> column(surface.place_count(), no_index);
  Index last_parent = no_index;
  // Patches of one parent are consecutive.
  for (Index p = 0; p < second.patch_count; ++p) {
    checkpoint();
    const Index parent = partition.parent[p];
    if (parent != last_parent) {
      const auto members = first.members(parent);
      for (std::size_t i = 0; i < members.size(); ++i) column[members[i]] = static_cast<Index>(i);
      last_parent = parent;
    }
    const auto nodes = second.nodes(p);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      parent_column[second.border.begin[p] + i] = column[second.node_place[nodes[i]]];
    }
  }

  first_face = first_faces(surface.second_layer, second.patch_count);
  first_child = first_faces(partition.parent, first.patch_count);
  second_node.reserve(first.node_count());
  for (Index vertex : first.node_place) second_node.push_back(second.place_node[vertex]);
  node_position.reserve(second.node_count());
  for (Index place : second.node_place) node_position.push_back(surface.position(place));
  for (Index e = 0; e < surface.mesh->edge_count() && !has_branches; ++e) {
    if (e % elements_per_checkpoint == 0) checkpoint();
    has_branches = surface.mesh->edge_face_count(e) > 2;
  }
}

}  // namespace vorogeo
