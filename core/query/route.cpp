// The ends of routes, by the tables of their patches.
#include "query/route.h"

#include <algorithm>

#include "support/processor.h"

namespace vorogeo {

void route_end(const IndexData& data, Index place, RouteEnd& end) {
  end.seeds.clear();
  end.parents.clear();
  end.patch = no_index;
  end.vertex = no_index;
  const PatchLayer& second = data.second;
  const Index node = second.place_node[place];
  auto add_parent = [&](Index patch) {
    const Index parent = data.partition.parent[patch];
    if (std::find(end.parents.begin(), end.parents.end(), parent) == end.parents.end())
      end.parents.push_back(parent);
  };
  if (node != no_index) {
    end.seeds.push_back({node, 0.0});
    for (const PatchRow& at : second.patches_of(node)) add_parent(at.patch);
    end.vertex = place;
    return;
  }
  end.patch = data.home_patch[place];
  add_parent(end.patch);
  const auto nodes = second.nodes(end.patch);
  const PatchLayer::Column entries = second.column_of(end.patch, data.home_column[place]);
  end.seeds.resize(nodes.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    end.seeds[count] = {nodes[i], entries.distance(static_cast<Index>(i))};
    count += end.seeds[count].distance < unreachable ? 1 : 0;
  }
  end.seeds.resize(count);
  end.vertex = place;
}

void find_stages(const IndexData& data, const GraphRoute& route, const RoutedPlace& source,
                 const RoutedPlace& target, std::vector<Stage>& stages) {
  stages.clear();
  if (route.nodes.empty()) return;
  Index at = source.place;
  auto add = [&](Leg leg, Index exit) {
    if (exit == at) return;
    if (!stages.empty() && stages.back().leg == leg) stages.pop_back();
    stages.push_back({leg, exit});
    at = exit;
  };
  auto leg_at = [&](const RoutedPlace& end) {
    return Leg{Leg::Table::second, end.patch != no_index ? end.patch : data.home_patch[end.place]};
  };
  auto place_of = [&](Index node) { return data.second.node_place[node]; };
  add(leg_at(source), place_of(route.nodes.front()));
  for (std::size_t i = 0; i < route.legs.size(); ++i) add(route.legs[i], place_of(route.nodes[i + 1]));
  add(leg_at(target), target.place);
}

void prefetch_end(const IndexData& data, Index place) {
  if (data.second.place_node[place] != no_index) return;
  const Index patch = data.home_patch[place];
  const PatchLayer::Column entries = data.second.column_of(patch, data.home_column[place]);
  for (Index row = 0; row < data.second.border_size(patch); ++row) prefetch_line(&entries.entry(row));
}

}  // namespace vorogeo
