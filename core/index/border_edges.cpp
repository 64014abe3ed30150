// Collecting the border edges of all patches by node.
#include "index/border_edges.h"

#include <algorithm>

#include "index/patch_layer.h"

namespace vorogeo {

BorderEdges::BorderEdges(const PatchLayer& layer) : edges_(layer.node_count()) {
  for (Index p = 0; p < layer.patch_count; ++p) {
    const auto nodes = layer.nodes(p);
    for (std::size_t row = 0; row < nodes.size(); ++row) {
      auto& edges = edges_[nodes[row]];
      for (const BorderNeighbour& next : layer.neighbours(p, static_cast<Index>(row))) {
        const Index other = nodes[next.row];
        const auto place = std::find_if(edges.begin(), edges.end(), [&](const Edge& edge) {
          return edge.node == other || edge.node == no_index;
        });
        if (place != edges.end()) *place = {other, next.length};
      }
    }
  }
  if (layer.neighbour.empty()) return;
  std::vector<float> lengths;
  lengths.reserve(layer.neighbour.size());
  for (const BorderNeighbour& next : layer.neighbour) lengths.push_back(next.length);
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  typical_length_ = *middle;
}

}  // namespace vorogeo
