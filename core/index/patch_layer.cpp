// A layer of patches: border nodes, members, and where tables hold their distances.
#include "index/patch_layer.h"

#include <algorithm>

#include "index/inner_surface.h"
#include "index/scans.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Layout of a patch layer from face labels

namespace {

/// Replaces a list by the patches of the faces at an edge, ascending.
void patches_at_edge(const Mesh& mesh, std::span<const Index> label, Index edge,
                     std::vector<Index>& patches) {
  patches.clear();
  mesh.for_each_halfedge(edge, [&](Index h) { patches.push_back(label[Mesh::face_of(h)]); });
  sort_once(patches);
}

/// Patches of the faces at each place, ascending.
Lists<Index> patches_of_places(const InnerSurface& surface, std::span<const Index> label) {
  const Mesh& mesh = *surface.mesh;
  Lists<Index> result;
  result.begin.reserve(surface.place_count() + 1);
  std::vector<Index> own;
  for (const Index place : checked(surface.place_count())) {
    if (surface.is_vertex(place)) {
      own.clear();
      for (Index corner : mesh.corners(place)) own.push_back(label[Mesh::face_of(corner)]);
      sort_once(own);
    } else {
      patches_at_edge(mesh, label, surface.point_at(place).edge, own);
    }
    result.add(own);
    result.close();
  }
  return result;
}

/// An edge between two or more patches, or a piece of one.
struct BorderPiece {
  Index edge;
  std::array<Index, 2> place;
  double length;
};

std::vector<BorderPiece> border_pieces(const InnerSurface& surface, std::span<const Index> label) {
  std::vector<BorderPiece> result;
  surface.for_each_piece([&](Index edge, Index from, Index to, double length) {
    if (edge % elements_per_checkpoint == 0) checkpoint();
    if (surface.is_border(edge, label)) result.push_back({edge, {from, to}, length});
  });
  return result;
}

/// Sorts nodes between the same patches, which are consecutive in `node_place`, into their order along the
/// border, so that nodes with close numbers are close to each other. `same` tells whether two places lie
/// between the same patches.
template <class Same>
void order_along_borders(Index place_count, const std::vector<BorderPiece>& pieces,
                         std::vector<Index>& node_place, Same&& same) {
  std::vector<std::vector<Index>> beside(node_place.size());
  std::vector<Index> node_of(place_count, no_index);
  for (std::size_t i = 0; i < node_place.size(); ++i) node_of[node_place[i]] = static_cast<Index>(i);
  for (const BorderPiece& piece : pieces) {
    const auto [a, b] = piece.place;
    if (!same(a, b)) continue;
    beside[node_of[a]].push_back(node_of[b]);
    beside[node_of[b]].push_back(node_of[a]);
  }
  std::vector<std::uint8_t> placed(node_place.size(), 0);
  std::vector<Index> ordered;
  ordered.reserve(node_place.size());
  auto walk = [&](std::size_t start) {
    auto at = static_cast<Index>(start);
    while (at != no_index) {
      placed[at] = 1;
      ordered.push_back(node_place[at]);
      Index next = no_index;
      for (Index other : beside[at]) {
        if (placed[other] == 0 && (next == no_index || other < next)) next = other;
      }
      at = next;
    }
  };
  for (std::size_t begin = 0, end = 0; begin < node_place.size(); begin = end) {
    while (end < node_place.size() && same(node_place[begin], node_place[end])) ++end;
    // From the ends of open stretches first; what remains are closed curves.
    for (std::size_t i = begin; i < end; ++i) {
      if (placed[i] == 0 && beside[i].size() < 2) walk(i);
    }
    for (std::size_t i = begin; i < end; ++i) {
      if (placed[i] == 0) walk(i);
    }
  }
  node_place.swap(ordered);
}

void find_touching(PatchLayer& layer) {
  std::vector<Index> own;
  for (Index patch = 0; patch < layer.patch_count; ++patch) {
    own.clear();
    for (Index node : layer.nodes(patch)) {
      for (const PatchRow& at : layer.patches_of(node)) {
        if (at.patch != patch) own.push_back(at.patch);
      }
    }
    sort_once(own);
    layer.touching.add(own);
    layer.touching.close();
  }
}

void find_stretches(PatchLayer& layer) {
  std::vector<BorderStretch>& stretches = layer.stretches.element;
  for (Index patch = 0; patch < layer.patch_count; ++patch) {
    Index row = 0;
    for (Index node : layer.nodes(patch)) {
      if (row > 0 && stretches.back().end == node) {
        ++stretches.back().end;
      } else {
        stretches.push_back({patch, row, node, node + 1});
      }
      ++row;
    }
    layer.stretches.close();
  }
}

/// The median length, which a few edges of whatever length hardly change.
double median_length(const std::vector<BorderNeighbour>& edges) {
  if (edges.empty()) return 0.0;
  std::vector<float> lengths;
  lengths.reserve(edges.size());
  for (const BorderNeighbour& edge : edges) lengths.push_back(edge.length);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::ranges::nth_element(lengths, middle);
  return *middle;
}

}  // namespace

PatchLayer lay_out_patches(const InnerSurface& surface, std::span<const Index> label, Index patch_count,
                           std::span<const std::uint8_t> candidate, TableOrder order) {
  const Lists<Index> around = patches_of_places(surface, label);
  const std::vector<BorderPiece> pieces = border_pieces(surface, label);
  PatchLayer layer;
  layer.patch_count = patch_count;
  layer.order = order;
  layer.place_node.assign(surface.place_count(), no_index);
  std::vector<std::vector<Index>> border(patch_count);
  std::vector<std::vector<Index>> inner(patch_count);
  for (const Index v : checked(surface.place_count())) {
    const auto patches = around[v];
    if (patches.size() >= 2) {
      layer.node_place.push_back(v);
    } else if (!patches.empty() && (candidate.empty() || candidate[v])) {
      inner[patches[0]].push_back(v);
    }
  }
  // Nodes between the same patches are consecutive, so that scans over a border are sequential in memory.
  std::stable_sort(layer.node_place.begin(), layer.node_place.end(), [&](Index a, Index b) {
    return std::ranges::lexicographical_compare(around[a], around[b]);
  });
  order_along_borders(surface.place_count(), pieces, layer.node_place,
                      [&](Index a, Index b) { return std::ranges::equal(around[a], around[b]); });
  for (Index node = 0; node < layer.node_count(); ++node) {
    const Index v = layer.node_place[node];
    layer.place_node[v] = node;
    for (Index p : around[v]) {
      layer.incidence.element.push_back({p, static_cast<Index>(border[p].size())});
      border[p].push_back(node);
    }
    layer.incidence.close();
  }

  layer.table_begin.push_back(0);
  for (Index p = 0; p < patch_count; ++p) {
    checkpoint();
    layer.border.add(border[p]);
    layer.border.close();
    for (Index node : border[p]) layer.member.element.push_back(layer.node_place[node]);
    layer.member.add(inner[p]);
    layer.member.close();
    layer.table_begin.push_back(layer.table_begin.back() + table_size(layer, p));
  }

  std::vector<std::vector<BorderNeighbour>> neighbours(layer.border.element.size());
  std::vector<Index> beside;
  for (const BorderPiece& piece : pieces) {
    const auto [a, b] = piece.place;
    const auto length = static_cast<float>(piece.length);
    patches_at_edge(*surface.mesh, label, piece.edge, beside);
    for (Index p : beside) {
      const Index row_a = layer.row_of(layer.place_node[a], p);
      const Index row_b = layer.row_of(layer.place_node[b], p);
      neighbours[layer.slot(p, row_a)].push_back({row_b, length});
      neighbours[layer.slot(p, row_b)].push_back({row_a, length});
    }
  }
  for (const auto& list : neighbours) {
    layer.neighbour.add(list);
    layer.neighbour.close();
  }
  layer.typical_border_edge = median_length(layer.neighbour.element);
  find_touching(layer);
  find_stretches(layer);
  layer.node_place.shrink_to_fit();
  for (auto* lists : {&layer.border, &layer.member, &layer.touching}) lists->shrink_to_fit();
  layer.incidence.shrink_to_fit();
  layer.neighbour.shrink_to_fit();
  layer.stretches.shrink_to_fit();
  return layer;
}

std::vector<Index> group_by_patches(const PatchLayer& layer, Index max_nodes) {
  std::vector<Index> begin;
  for (Index node = 0; node < layer.node_count(); ++node) {
    const bool joins = !begin.empty() && node - begin.back() < max_nodes &&
                       std::ranges::equal(layer.patches_of(node), layer.patches_of(begin.back()), {},
                                          &PatchRow::patch, &PatchRow::patch);
    if (!joins) begin.push_back(node);
  }
  begin.push_back(layer.node_count());
  return begin;
}

std::int64_t pairs_of_nodes(const PatchLayer& layer) {
  std::int64_t pairs = 0;
  for (Index p = 0; p < layer.patch_count; ++p) {
    const std::int64_t rows = layer.border_size(p);
    pairs += rows * (rows - 1) / 2;
  }
  return pairs;
}

std::size_t table_size(const PatchLayer& layer, Index patch) {
  const auto width = static_cast<std::size_t>(width_of(layer.order));
  const std::size_t columns = (layer.member_count(patch) + width - 1) / width * width;
  return columns * layer.border_size(patch);
}

void PatchLayer::read_border(Index patch, Index row, float* distances) const {
  const BorderStretch all{patch, 0, 0, border_size(patch)};
  for_each_run(all, row, [&](const BorderStretch& part, const std::uint16_t* entries) {
    scale_entries(entries, part.end - part.begin, scale[patch], distances + part.row);
  });
}

std::size_t PatchLayer::memory_bytes() const {
  auto bytes = [](const auto& v) { return v.size() * sizeof(v[0]); };
  return bytes(node_place) + bytes(place_node) + border.memory_bytes() + member.memory_bytes() +
         incidence.memory_bytes() + neighbour.memory_bytes() + touching.memory_bytes() +
         stretches.memory_bytes() + bytes(table_begin) + bytes(table) + bytes(scale) + bytes(offset) +
         bytes(complete);
}

}  // namespace vorogeo
