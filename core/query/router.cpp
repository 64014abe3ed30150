// Which router has the shortest route.
#include "query/router.h"

#include <algorithm>

namespace vorogeo {

void Router::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result) {
  if (data_.graph.has_arcs()) {
    graph_.route(source, target, result);
    return;
  }
  result.length = unreachable;
  result.nodes.clear();
  result.arc_patches.clear();
  const bool neighbours =
      std::find_first_of(source.parents.begin(), source.parents.end(), target.parents.begin(),
                         target.parents.end()) != source.parents.end();
  if (neighbours) patches_.route(source, target, result);
  tables_.route(source, target, result, result.length);
}

}  // namespace vorogeo
