// What follows from mesh and partition, and what an index holds.
#include "index/index_data.h"

#include "patches/halo.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

void IndexData::lay_out(int threads, const Progress& progress) {
  {
    const Watch watch(progress.part(0.0, 0.5), "Laying out the patches");
    surface = InnerSurface(*mesh, partition);
  }
  // What the solver needs and what the tables need, in parallel.
  parallel_for(2, threads, progress.part(0.5, 0.8), "Laying out the patches", [&](std::size_t half, int) {
    if (half == 0) {
      geometry = std::make_shared<const LocalGeometry>(surface.mesh);
    } else {
      second =
          lay_out_patches(surface, surface.second_layer, partition.second_layer_count, {}, TableOrder::tiles);
    }
  });
  const Watch watch(progress.part(0.8, 1.0), "Laying out the patches");
  std::vector<std::uint8_t> is_node(surface.place_count());
  for (Index place = 0; place < surface.place_count(); ++place) {
    is_node[place] = second.place_node[place] != no_index;
  }
  std::vector<Index> first_label(surface.second_layer);
  for (Index& label : first_label) label = partition.parent[label];
  first = lay_out_patches(surface, first_label, partition.first_layer_count, is_node);

  home_patch.assign(surface.place_count(), no_index);
  home_column.assign(surface.place_count(), no_index);
  for (Index p = 0; p < second.patch_count; ++p) {
    const auto members = second.members(p);
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (home_patch[members[i]] != no_index) continue;
      home_patch[members[i]] = p;
      home_column[members[i]] = static_cast<Index>(i);
    }
  }

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
  longest_piece.assign(second.patch_count, 0.0);
  const Mesh& inner = *surface.mesh;
  for (const Index f : checked(inner.face_count())) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index other = inner.next_around_edge(h);
      has_branches |= inner.next_around_edge(other) != h;
      if (surface.second_layer[f] == surface.second_layer[Mesh::face_of(other)]) continue;
      const Index edge = inner.edge_of(h);
      const auto [begin, end] = surface.places_inside(edge);
      const double piece = inner.edge_length(edge) / (1.0 + end - begin);
      double& longest = longest_piece[surface.second_layer[f]];
      if (piece < unreachable) longest = std::max(longest, piece);
    }
  }
}

std::int64_t IndexData::bytes() const {
  auto of = [](const auto& list) { return list.size() * sizeof(list[0]); };
  return static_cast<std::int64_t>(
      first.memory_bytes() + second.memory_bytes() + graph.memory_bytes() + transit_table.memory_bytes() +
      access_bounds.memory_bytes() + landmarks.memory_bytes() + surface.memory_bytes() +
      geometry->memory_bytes() + of(partition.first_layer) + of(partition.second_layer) +
      of(partition.parent) + of(parent_column) + of(home_patch) + of(home_column) + of(first_face) +
      of(first_child) + of(second_node) + of(node_position) + of(longest_piece));
}

void IndexData::count() {
  statistics.vertices = mesh->given_vertex_count();
  statistics.faces = mesh->face_count();
  statistics.components = mesh->component_count();
  statistics.first_layer_patches = first.patch_count;
  statistics.second_layer_patches = second.patch_count;
  statistics.first_layer_border_vertices = first.node_count();
  statistics.second_layer_border_vertices = second.node_count();
  statistics.form = form();
  statistics.delta = head.delta;
  statistics.seed = head.numbers[IndexHead::seed];
  statistics.arcs_before_pruning = pairs_of_nodes(first) + pairs_of_nodes(second);
  statistics.arcs = statistics.arcs_before_pruning;
  if (form() == IndexForm::graph) {
    statistics.arcs -= pairs_of_nodes(first) - static_cast<std::int64_t>(graph.arc.size() / 2);
  }
  statistics.bytes = bytes();
}

void IndexData::note_mapped_bytes() {
  statistics.mapped_bytes = 0;
  for (const auto* table : {&second.table, &first.table, &transit_table.entry}) {
    statistics.mapped_bytes += static_cast<std::int64_t>(table->size() * sizeof((*table)[0]));
  }
}

}  // namespace vorogeo
