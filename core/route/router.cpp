// Selects the router that has the shortest route.
#include "route/router.h"

#include <algorithm>

namespace vorogeo {

void Router::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result) {
  if (data_.graph.has_arcs()) {
    if (!graph_) graph_.emplace(data_);
    graph_->route(source, target, result);
    return;
  }
  result.length = unreachable;
  result.nodes.clear();
  result.legs.clear();
  const bool neighbours =
      std::find_first_of(source.parents.begin(), source.parents.end(), target.parents.begin(),
                         target.parents.end()) != source.parents.end();
  if (neighbours) {
    if (!patches_) patches_.emplace(data_);
    patches_->route(source, target, result);
  }
  if (!tables_) tables_.emplace(data_);
  tables_->route(source, target, result, result.length);
}

}  // namespace vorogeo
