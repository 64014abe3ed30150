// The shortest route of two points by whatever tables there are, and its length with borders unfolded.
#include "query/router.h"

#include <algorithm>
#include <array>
#include <vector>

#include "index/unfolding.h"

namespace vorogeo {

// ---- Walks a route table by table with the distances of a few border nodes at each crossing

namespace {

using Near = RouteUnfolder::Near;

/// Distance between two vertices by the table of a leg; unreachable if it does not hold both.
double distance_by(const IndexData& data, const Leg& leg, Index from, Index to) {
  if (leg.table == Leg::Table::transit) {
    const Index a = data.first.place_node[from];
    const Index b = data.first.place_node[to];
    return a == no_index || b == no_index ? unreachable : data.transit_table.distance(a, b);
  }
  const PatchLayer& layer = leg.table == Leg::Table::first ? data.first : data.second;
  auto column_of = [&](Index vertex) {
    return leg.table == Leg::Table::second ? data.column_in_patch(leg.patch, vertex)
                                           : data.column_in_parent(leg.patch, data.second.place_node[vertex]);
  };
  Index row = layer.row_in(from, leg.patch);
  Index other = to;
  if (row == no_index) {
    row = layer.row_in(to, leg.patch);
    other = from;
  }
  const Index column = row == no_index ? no_index : column_of(other);
  return column == no_index ? unreachable : layer.distance(leg.patch, row, column);
}

/// Least distance of a vertex through the near nodes, then across the border edges at the best of them.
double cross(const IndexData& data, const Leg& leg, const std::vector<Near>& near, Index vertex) {
  std::array<double, 8> beyond{};
  const std::size_t count = std::min(near.size(), beyond.size());
  double best = unreachable;
  std::size_t least = 0;
  for (std::size_t i = 0; i < count; ++i) {
    beyond[i] = distance_by(data, leg, near[i].vertex, vertex);
    if (near[i].distance + beyond[i] < best) {
      best = near[i].distance + beyond[i];
      least = i;
    }
  }
  if (best == unreachable) return best;
  Crossing<double> crossing{near[least].distance, beyond[least]};
  for (std::size_t i = 0; i < count; ++i) {
    // Only the route's own node is a neighbour of all the others.
    if (i == least || (least != 0 && i != 0) || beyond[i] == unreachable) continue;
    crossing.add({near[i].distance, beyond[i], near[std::max(i, least)].length});
  }
  return crossing_distance(crossing);
}

/// Calls visit(vertex, length) for the border neighbours of the vertex where the route passes from one stage
/// to the next: along the border of a patch on either side that has the vertex on its border.
template <class Visit>
void for_each_neighbour(const IndexData& data, const Stage& stage, const Stage& next, Visit&& visit) {
  for (const Leg& side : {stage.leg, next.leg}) {
    if (side.table == Leg::Table::transit) continue;
    const PatchLayer& layer = side.table == Leg::Table::first ? data.first : data.second;
    const Index row = layer.row_in(stage.exit, side.patch);
    if (row == no_index) continue;
    for (const BorderNeighbour& beside : layer.neighbours(side.patch, row)) {
      visit(layer.node_place[layer.nodes(side.patch)[beside.row]], beside.length);
    }
    return;
  }
}

}  // namespace

double RouteUnfolder::length(const GraphRoute& route, const RoutedPlace& source, const RoutedPlace& target) {
  find_stages(data_, route, source, target, stages_);
  if (stages_.empty()) return source.place == target.place ? 0.0 : unreachable;
  near_.assign(1, {source.place, 0.0, 0.0});
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    const Stage& stage = stages_[i];
    next_.clear();
    next_.push_back({stage.exit, cross(data_, stage.leg, near_, stage.exit), 0.0});
    if (i + 1 < stages_.size()) {
      for_each_neighbour(data_, stage, stages_[i + 1], [&](Index vertex, double length) {
        next_.push_back({vertex, cross(data_, stage.leg, near_, vertex), length});
      });
    }
    near_.swap(next_);
  }
  return near_.front().distance;
}

// ---- Selects the router that has the shortest route

void Router::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result) {
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
  if (data_.form() == IndexForm::graph) {
    if (!graph_) graph_.emplace(data_);
    graph_->route(source, target, result);
  } else {
    if (!tables_) tables_.emplace(data_);
    tables_->route(source, target, result);
  }
}

}  // namespace vorogeo
