// Layout of a patch layer from face labels.
#include "index/patch_layer.h"

#include <algorithm>

namespace vorogeo {

namespace {

/// Patches of the faces at each vertex, as a list per vertex in ascending order.
struct VertexPatches {
  std::vector<Index> begin;
  std::vector<Index> patch;
};

VertexPatches patches_of_vertices(const Mesh& mesh, std::span<const Index> label) {
  VertexPatches result;
  result.begin.reserve(mesh.vertex_count() + 1);
  result.begin.push_back(0);
  std::vector<Index> own;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    own.clear();
    for (Index corner : mesh.corners(v)) own.push_back(label[Mesh::face_of(corner)]);
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    result.patch.insert(result.patch.end(), own.begin(), own.end());
    result.begin.push_back(static_cast<Index>(result.patch.size()));
  }
  return result;
}

}  // namespace

PatchLayer lay_out_patches(const Mesh& mesh, std::span<const Index> label, Index patch_count,
                           std::span<const std::uint8_t> candidate) {
  const auto around = patches_of_vertices(mesh, label);
  auto patches_at = [&](Index v) {
    return std::span(around.patch.data() + around.begin[v], around.patch.data() + around.begin[v + 1]);
  };
  PatchLayer layer;
  layer.patch_count = patch_count;
  layer.vertex_node.assign(mesh.vertex_count(), no_index);
  std::vector<std::vector<Index>> border(patch_count);
  std::vector<std::vector<Index>> inner(patch_count);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto patches = patches_at(v);
    if (patches.size() >= 2) {
      layer.node_vertex.push_back(v);
    } else if (!patches.empty() && (candidate.empty() || candidate[v])) {
      inner[patches[0]].push_back(v);
    }
  }
  // Nodes between the same patches follow one another, so that scans over a border run through memory.
  std::stable_sort(layer.node_vertex.begin(), layer.node_vertex.end(), [&](Index a, Index b) {
    const auto of_a = patches_at(a);
    const auto of_b = patches_at(b);
    return std::lexicographical_compare(of_a.begin(), of_a.end(), of_b.begin(), of_b.end());
  });
  layer.incidence_begin.push_back(0);
  for (Index node = 0; node < layer.node_count(); ++node) {
    const Index v = layer.node_vertex[node];
    layer.vertex_node[v] = node;
    for (Index p : patches_at(v)) {
      layer.incidence.push_back({p, static_cast<Index>(border[p].size())});
      border[p].push_back(v);
    }
    layer.incidence_begin.push_back(static_cast<Index>(layer.incidence.size()));
  }

  layer.border_begin.push_back(0);
  layer.member_begin.push_back(0);
  layer.table_begin.push_back(0);
  for (Index p = 0; p < patch_count; ++p) {
    for (Index v : border[p]) layer.border_node.push_back(layer.vertex_node[v]);
    layer.member.insert(layer.member.end(), border[p].begin(), border[p].end());
    layer.member.insert(layer.member.end(), inner[p].begin(), inner[p].end());
    layer.border_begin.push_back(static_cast<Index>(layer.border_node.size()));
    layer.member_begin.push_back(static_cast<Index>(layer.member.size()));
    layer.table_begin.push_back(layer.table_begin.back() +
                                static_cast<std::size_t>(layer.border_size(p)) * layer.member_count(p));
  }

  // Border edges: faces of two or more patches meet there.
  std::vector<std::vector<BorderNeighbour>> neighbours(layer.border_node.size());
  auto row_in = [&](Index vertex, Index patch) {
    for (const PatchRow& at : layer.patches_of(layer.vertex_node[vertex])) {
      if (at.patch == patch) return at.row;
    }
    return no_index;
  };
  std::vector<Index> beside;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    if (layer.vertex_node[a] == no_index || layer.vertex_node[b] == no_index) continue;
    beside.clear();
    const Index first = mesh.edge_halfedge(e);
    Index h = first;
    do {
      beside.push_back(label[Mesh::face_of(h)]);
      h = mesh.next_around_edge(h);
    } while (h != first);
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    if (beside.size() < 2) continue;
    const auto length = static_cast<float>(mesh.edge_length(e));
    for (Index p : beside) {
      const Index row_a = row_in(a, p);
      const Index row_b = row_in(b, p);
      neighbours[layer.border_begin[p] + row_a].push_back({row_b, length});
      neighbours[layer.border_begin[p] + row_b].push_back({row_a, length});
    }
  }
  layer.neighbour_begin.push_back(0);
  for (const auto& list : neighbours) {
    layer.neighbour.insert(layer.neighbour.end(), list.begin(), list.end());
    layer.neighbour_begin.push_back(static_cast<Index>(layer.neighbour.size()));
  }
  for (auto* list : {&layer.node_vertex, &layer.border_begin, &layer.border_node, &layer.member_begin,
                     &layer.member, &layer.incidence_begin, &layer.neighbour_begin}) {
    list->shrink_to_fit();
  }
  layer.incidence.shrink_to_fit();
  layer.neighbour.shrink_to_fit();
  return layer;
}

std::vector<NodeRange> node_ranges(const PatchLayer& layer, Index patch) {
  std::vector<NodeRange> ranges;
  for (Index node : layer.nodes(patch)) {
    if (!ranges.empty() && ranges.back().end == node) {
      ++ranges.back().end;
    } else {
      ranges.push_back({node, node + 1});
    }
  }
  return ranges;
}

void make_tables(PatchLayer& layer) {
  layer.table.assign(layer.table_begin.back(), std::numeric_limits<float>::infinity());
}

void make_symmetric(PatchLayer& layer) {
  for (Index p = 0; p < layer.patch_count; ++p) {
    for (Index i = 0; i < layer.border_size(p); ++i) {
      layer.line(p, i)[i] = 0.0f;
      for (Index j = 0; j < i; ++j) {
        float& forth = layer.line(p, i)[j];
        float& back = layer.line(p, j)[i];
        forth = back = std::min(forth, back);
      }
    }
  }
}

std::size_t PatchLayer::memory_bytes() const {
  auto bytes = [](const auto& v) { return v.size() * sizeof(v[0]); };
  return bytes(node_vertex) + bytes(vertex_node) + bytes(border_begin) + bytes(border_node) +
         bytes(member_begin) + bytes(member) + bytes(incidence_begin) + bytes(incidence) +
         bytes(neighbour_begin) + bytes(neighbour) + bytes(table_begin) + bytes(table);
}

}  // namespace vorogeo
