// Collecting the border edges of all patches by node.
#include "index/border_edges.h"

#include <algorithm>

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
}

}  // namespace vorogeo
