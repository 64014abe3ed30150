// The chain of border vertices of a route, and the strip of faces along it.
#include "query/path_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <unordered_map>
#include <vector>

#include "index/index_data.h"
#include "index/local_tables.h"
#include "mesh/surface_point.h"
#include "support/processor.h"
#include "support/progress.h"

namespace vorogeo {

// ---- A* search with the straight line, shortened by what a metric may save, as lower bound

bool path_along_edges(const Mesh& mesh, Index start, Index goal, std::vector<EdgeStep>& path) {
  struct Entry {
    double key;
    Index vertex;
    bool operator<(const Entry& other) const { return key > other.key; }
  };
  struct Reached {
    double distance;
    EdgeStep by;
  };
  const Point& end = mesh.position(goal);
  auto straight = [&](Index v) {
    const Point& p = mesh.position(v);
    const double x = p[0] - end[0], y = p[1] - end[1], z = p[2] - end[2];
    return mesh.straight_scale() > 0.0 ? mesh.straight_scale() * std::sqrt(x * x + y * y + z * z) : 0.0;
  };
  std::unordered_map<Index, Reached> reached{{start, {0.0, {no_index, no_index}}}};
  std::priority_queue<Entry> queue;
  queue.push({straight(start), start});
  std::size_t looked_at = 0;
  // This loop ends: a vertex enters the queue again only with a smaller distance, which is the length of
  // another path.
  while (!queue.empty()) {
    const auto [key, vertex] = queue.top();
    queue.pop();
    if (vertex == goal) break;
    if (++looked_at % 256 == 0) checkpoint();
    const double at = reached.at(vertex).distance;
    if (key > (at + straight(vertex)) * (1.0 + 1e-12)) continue;
    for (Index corner : mesh.corners(vertex)) {
      for (Index side : {corner, Mesh::previous_in_face(corner)}) {
        const Index other = side == corner ? mesh.head(side) : mesh.tail(side);
        const Reached found{at + mesh.edge_length(mesh.edge_of(side)), {side, vertex}};
        const auto [known, is_new] = reached.try_emplace(other, found);
        if (!is_new) {
          if (known->second.distance <= found.distance) continue;
          known->second = found;
        }
        queue.push({found.distance + straight(other), other});
      }
    }
  }
  if (!reached.contains(goal)) return false;
  const auto first = static_cast<std::ptrdiff_t>(path.size());
  for (Index v = goal; v != start; v = path.back().from) path.push_back(reached.at(v).by);
  std::reverse(path.begin() + first, path.end());
  return true;
}

// ---- Patches and border distances of end points

PathEnd::PathEnd(const Mesh& mesh, const SurfacePoint& at) : point(at), vertex(at.vertex) {
  if (point.is_vertex()) return;
  const auto distances = distances_in_face(mesh, point);
  const auto nearest = std::ranges::min_element(distances);
  to_vertex = *nearest;
  vertex = mesh.face_vertices(point.face)[nearest - distances.begin()];
}

PathEnd::PathEnd(const IndexData& data, const SurfacePoint& user)
    : PathEnd(*data.work.mesh, work_point(data, user)) {
  for_each_face_at(*data.work.mesh, point, [&](Index face, const std::array<double, 3>&) {
    const Index patch = data.work.second_layer[face];
    if (std::ranges::find(patches, patch) == patches.end()) patches.push_back(patch);
  });
}

bool are_near(const IndexData& data, const PathEnd& a, const PathEnd& b) {
  auto is_of_b = [&](Index p) { return std::ranges::find(b.patches, p) != b.patches.end(); };
  return std::ranges::any_of(a.patches, [&](Index p) {
    return is_of_b(p) || std::ranges::any_of(data.second.touching.of(p), is_of_b);
  });
}

RouteEnd route_end_of(const IndexData& data, const PathEnd& end) {
  RouteEnd result;
  if (end.point.is_vertex()) {
    route_end(data, end.vertex, result);
    return result;
  }
  result.patch = end.patch(data);
  const auto nodes = data.second.nodes(result.patch);
  result.parents.push_back(data.partition.parent[result.patch]);
  const Mesh& mesh = *data.work.mesh;
  std::array<Index, 3> column{};
  for (int k = 0; k < 3; ++k) {
    column[k] = data.column_in_patch(result.patch, mesh.face_vertices(end.point.face)[k]);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::array<double, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      corners[k] = data.second.distance(result.patch, static_cast<Index>(i), column[k]);
    }
    const double distance = distance_in_face(mesh, end.point.face, end.point.barycentric, corners);
    if (distance < unreachable) result.seeds.push_back({nodes[i], distance});
  }
  return result;
}

// ---- A walk for each step of the chain

bool strip_along_chain(const IndexData& data, const PathChain& chain, FaceStrip& strip) {
  const Mesh& mesh = *data.work.mesh;
  strip.first = strip.source.face;
  strip.crossings.clear();
  std::vector<StepWalk> walks;
  std::vector<std::uint8_t> forwards;
  walks.reserve(chain.steps.size());
  Index vertex = chain.source;
  for (const ChainStep& step : chain.steps) {
    forwards.push_back(step.patch == no_index || data.row_in_patch(step.patch, step.vertex) != no_index);
    walks.emplace_back(data, step.patch, forwards.back() ? vertex : step.vertex,
                       forwards.back() ? step.vertex : vertex);
    vertex = step.vertex;
  }
  std::vector<StepWalk*> going;
  for (StepWalk& walk : walks) going.push_back(&walk);
  // Each walk terminates (path_chain.h).
  while (!going.empty()) std::erase_if(going, [](StepWalk* walk) { return !walk->go_on(); });
  vertex = chain.source;
  for (std::size_t k = 0; k < walks.size(); ++k) {
    if (!walks[k].arrived()) return false;
    const auto& passed = walks[k].passed();
    for (std::size_t i = 0; i < passed.size(); ++i) {
      const std::size_t at = forwards[k] ? i : passed.size() - 1 - i;
      Index exit = passed[at].exit;
      Index entry = passed[at].entry;
      Index pivot = passed[at].pivot;
      if (!forwards[k]) {
        // The crossing to the face walked after this one, in the opposite direction.
        const bool first = at + 1 == passed.size();
        exit = first ? no_index : passed[at + 1].entry;
        entry = first ? no_index : passed[at + 1].exit;
        pivot = first ? vertex : passed[at + 1].pivot;
      }
      if (strip.first == no_index) {
        strip.first = passed[at].face;
      } else if (exit != no_index) {
        strip.crossings.push_back({exit, entry});
      } else if (!turn_around(mesh, strip, pivot, passed[at].face)) {
        return false;
      }
    }
    vertex = chain.steps[k].vertex;
  }
  if (strip.first == no_index) strip.first = Mesh::face_of(mesh.corners(strip.source.vertex).front());
  if (strip.target.is_vertex()) {
    const auto& last = mesh.face_vertices(strip.last());
    if (std::find(last.begin(), last.end(), strip.target.vertex) == last.end()) return false;
  } else if (!turn_around(mesh, strip, vertex, strip.target.face)) {
    return false;
  }
  return true;
}

// ---- In each face the distances of two vertices are unfolded into the plane

namespace {

/// A walk is abandoned when it becomes this many times as long as it should be.
constexpr double longer = 1.1;

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace

StepWalk::StepWalk(const IndexData& data, Index patch, Index start, Index goal)
    : data_(data),
      mesh_(*data.work.mesh),
      geometry_(*data.geometry->windows),
      patch_(patch),
      row_(patch == no_index ? no_index : data.row_in_patch(patch, goal)),
      goal_(goal),
      vertex_(start) {
  passed_.reserve(64);
}

bool StepWalk::go_on() {
  switch (next_) {
    case Next::meet_vertex:
      meet_vertex();
      break;
    case Next::look_around:
      for (Index corner : mesh_.corners(vertex_)) fetch_column(mesh_.head(corner));
      next_ = Next::look_up_ring;
      break;
    case Next::look_up_ring:
      for (Index corner : mesh_.corners(vertex_)) fetch_distance(mesh_.head(corner));
      next_ = Next::leave_vertex;
      break;
    case Next::leave_vertex:
      leave();
      break;
    case Next::find_apex:
      fetch_column(geometry_.frame[entry_].apex);
      next_ = Next::look_up_apex;
      break;
    case Next::look_up_apex:
      column_ = fetch_distance(geometry_.frame[entry_].apex);
      next_ = Next::cross_face;
      break;
    case Next::cross_face:
      enter_face();
      break;
    case Next::nothing:
      break;
  }
  return next_ != Next::nothing;
}

void StepWalk::fetch_column(Index vertex) const {
  prefetch_line(&data_.second.vertex_node[vertex]);
  prefetch_line(&data_.home_patch[vertex]);
  prefetch_line(&data_.home_column[vertex]);
}

Index StepWalk::fetch_distance(Index vertex) const {
  const Index column = data_.column_in_patch(patch_, vertex);
  if (column != no_index) {
    const PatchLayer::Column entries = data_.second.column_of(patch_, column);
    prefetch_line(entries.first + static_cast<std::size_t>(row_) * entries.step);
  }
  return column;
}

void StepWalk::meet_vertex() {
  if (vertex_ == goal_) {
    next_ = Next::nothing;
    return;
  }
  if (row_ == no_index) {
    walk_along_edges();
    return;
  }
  for (Index corner : mesh_.corners(vertex_)) {
    const Index opposite = Mesh::next_in_face(corner);
    prefetch_line(&geometry_.frame[opposite]);
    prefetch_line(&mesh_.face_vertices(Mesh::face_of(corner)));
    mesh_.prefetch_around_edge(opposite);
  }
  next_ = Next::look_around;
}

void StepWalk::leave() {
  straight_from_ = passed_.size();
  at_last_ = distance(vertex_);
  expected_ = at_last_ * longer;
  faces_left_ = 4 * static_cast<std::size_t>(data_.second.member_count(patch_)) + 64;
  move_ = leave_vertex(vertex_);
  take_move({move_.face, no_index, no_index, vertex_});
}

void StepWalk::enter_face() {
  const Index exit = move_.halfedge;
  expected_ = std::min(expected_, move_.length * longer);
  move_ = cross(entry_, move_, distance_at(column_));
  take_move({Mesh::face_of(entry_), exit, entry_, no_index});
}

void StepWalk::take_move(const PassedFace& face) {
  if (move_.face == no_index || move_.length > expected_ || --faces_left_ == 0) {
    passed_.resize(straight_from_);
    walk_along_edges();
    return;
  }
  passed_.push_back(face);
  if (move_.vertex != no_index) {
    vertex_ = move_.vertex;
    next_ = Next::meet_vertex;
    return;
  }
  entry_ = mesh_.next_around_edge(move_.halfedge);
  prefetch_line(&geometry_.frame[entry_]);
  mesh_.prefetch_around_edge(entry_);
  next_ = Next::find_apex;
}

void StepWalk::walk_along_edges() {
  std::vector<EdgeStep> path;
  if (path_along_edges(mesh_, vertex_, goal_, path)) vertex_ = goal_;
  for (const EdgeStep& step : path) {
    passed_.push_back({Mesh::face_of(step.halfedge), no_index, no_index, step.from});
  }
  next_ = Next::nothing;
}

double StepWalk::distance_at(Index column) const {
  return column == no_index ? unreachable : data_.second.distance(patch_, row_, column);
}

double StepWalk::distance(Index vertex) const { return distance_at(data_.column_in_patch(patch_, vertex)); }

void StepWalk::through_edge(double px, double py, double length, double at_0, double at_length,
                            Index halfedge, Move& best) {
  if (!(at_0 < unreachable && at_length < unreachable && length > 0.0)) return;
  const double difference = at_0 - at_length;
  if (std::abs(difference) > length) return;
  const double x = 0.5 * (length + difference * (at_0 + at_length) / length);
  const double y = std::sqrt(std::max(0.0, (at_0 - x) * (at_0 + x)));
  if (!(y + py > 0.0)) return;
  const double crossing = px + (x - px) * (py / (y + py));
  if (!(crossing > 0.0 && crossing < length)) return;
  const double step_length = length_of(x - px, y + py);
  if (step_length < best.length) {
    best = {step_length, Mesh::face_of(halfedge), no_index, halfedge, crossing, length, at_0, at_length};
  }
}

void StepWalk::to_vertex(double step, double from_there, Index face, Index vertex, Move& best) const {
  if (from_there < at_last_ && step + from_there < best.length) {
    best = {step + from_there, face, vertex};
  }
}

StepWalk::Move StepWalk::leave_vertex(Index vertex) const {
  Move best;
  // Neighbours are consecutive in the fan: each is an end of two of the opposite edges.
  std::array<Index, 2> known{no_index, no_index};
  std::array<double, 2> at{unreachable, unreachable};
  for (Index corner : mesh_.corners(vertex)) {
    const Index opposite = Mesh::next_in_face(corner);
    const Index face = Mesh::face_of(corner);
    const FaceFrame& frame = geometry_.frame[opposite];
    std::array<Index, 2> ends{mesh_.tail(opposite), mesh_.head(opposite)};
    if (!frame.along) std::swap(ends[0], ends[1]);
    std::array<double, 2> there{};
    for (int i = 0; i < 2; ++i) {
      const bool is_known = ends[i] == known[0] || ends[i] == known[1];
      there[i] = is_known ? at[ends[i] == known[0] ? 0 : 1] : distance(ends[i]);
      if (is_known) continue;
      const Index side = mesh_.head(corner) == ends[i] ? corner : Mesh::previous_in_face(corner);
      to_vertex(mesh_.edge_length(mesh_.edge_of(side)), there[i], face, ends[i], best);
    }
    known = ends;
    at = there;
    if (mesh_.next_around_edge(opposite) == opposite) continue;
    through_edge(frame.apex_x, frame.apex_depth, mesh_.edge_length(mesh_.edge_of(opposite)), there[0],
                 there[1], opposite, best);
    if (best.halfedge == opposite) {
      best.first = ends[0];
      best.second = ends[1];
    }
  }
  return best;
}

StepWalk::Move StepWalk::cross(Index halfedge, const Move& last, double at_apex) const {
  const double x = last.x;
  const FaceFrame& frame = geometry_.frame[halfedge];
  const double length = last.edge_length;
  const Index face = Mesh::face_of(halfedge);
  Move best;
  to_vertex(length_of(frame.apex_x - x, frame.apex_depth), at_apex, face, frame.apex, best);
  to_vertex(x, last.at_first, face, last.first, best);
  to_vertex(length - x, last.at_second, face, last.second, best);
  for (const bool first : {true, false}) {
    const Index side = first ? frame.first_side(halfedge) : frame.second_side(halfedge);
    // The point in the frame of the side, whose x axis begins at the vertex that it shares with the crossed
    // edge.
    const double from_shared = first ? x : length - x;
    const double along = first ? frame.apex_x : length - frame.apex_x;
    const double side_length = length_of(along, frame.apex_depth);
    if (!(side_length > 0.0) || mesh_.next_around_edge(side) == side) continue;
    const double cosine = along / side_length;
    const double sine = frame.apex_depth / side_length;
    Move move;
    through_edge(from_shared * cosine, from_shared * sine, side_length,
                 first ? last.at_first : last.at_second, at_apex, side, move);
    if (!(move.length < best.length)) continue;
    move.first = first ? last.first : last.second;
    move.second = frame.apex;
    if (first ? frame.first_side_reversed : frame.second_side_reversed) {
      move.x = side_length - move.x;
      std::swap(move.first, move.second);
      std::swap(move.at_first, move.at_second);
    }
    best = move;
  }
  return best;
}

// ---- Walks back through the tables of each layer, from the end of a leg to its beginning

namespace {

/// Sums that exceed the least by no more than this factor are equal within the precision of the tables: the
/// step to the goal is then preferred.
constexpr double equal_sums = 1e-6;

class ChainBuilder {
 public:
  ChainBuilder(const IndexData& data, PathChain& chain) : data_(data), chain_(chain) {}

  void second_layer_step(Index patch, Index vertex) { chain_.steps.push_back({vertex, patch}); }

  /// From second-layer node a to b by the table of first-layer patch `parent`; one of them is on its border.
  void first_layer_step(Index parent, Index a, Index b) {
    const bool backwards = first_row(parent, a) == no_index;
    const Index fixed = first_row(parent, backwards ? b : a);
    if (fixed == no_index) {
      second_layer_step(no_index, vertex_of(b));
      return;
    }
    auto from_goal = [&](Index node) { return from_row(parent, fixed, node); };
    auto lines = [&](const PatchRow& at, std::vector<float>& length, std::vector<double>& rest) {
      const auto nodes = data_.second.nodes(at.patch);
      length.resize(nodes.size());
      rest.resize(nodes.size());
      const bool inside = data_.partition.parent[at.patch] == parent;
      const Index* columns = data_.parent_column.data() + data_.second.border_begin[at.patch];
      for (std::size_t i = 0; inside && i < nodes.size(); ++i) {
        // Each entry is in a cache line of its own.
        const PatchLayer::Column entries = data_.first.column_of(parent, columns[i]);
        prefetch_line(entries.first + static_cast<std::size_t>(fixed) * entries.step);
      }
      data_.second.read_border(at.patch, at.row, length.data());
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        rest[i] = inside ? data_.first.distance(parent, fixed, columns[i]) : from_goal(nodes[i]);
      }
    };
    // Backwards from the other end to the goal, by the goal's distances.
    back_.clear();
    walk(data_.second, backwards ? a : b, backwards ? b : a, 1.0, from_goal, lines);
    for (std::size_t k = 0; k < back_.size(); ++k) {
      if (backwards) {
        second_layer_step(back_[k].patch, vertex_of(back_[k].to));
      } else {
        const Step& step = back_[back_.size() - 1 - k];
        second_layer_step(step.patch, vertex_of(step.from));
      }
    }
  }

  /// From one first-layer node to another by the transit table; both are given by their second-layer nodes.
  void transit_table_step(Index a, Index b) {
    const Index goal = data_.first.vertex_node[vertex_of(a)];
    auto from_goal = [&](Index node) -> double { return data_.transit_table.distance(goal, node); };
    auto lines = [&](const PatchRow& at, std::vector<float>& length, std::vector<double>& rest) {
      const auto nodes = data_.first.nodes(at.patch);
      length.resize(nodes.size());
      rest.resize(nodes.size());
      data_.first.read_border(at.patch, at.row, length.data());
      for (std::size_t i = 0; i < nodes.size(); ++i) rest[i] = from_goal(nodes[i]);
    };
    back_.clear();
    walk(data_.first, data_.first.vertex_node[vertex_of(b)], goal, 1.0 + equal_sums, from_goal, lines);
    const std::vector<Step> steps(back_.rbegin(), back_.rend());
    for (const Step& step : steps) {
      if (step.patch == no_index) {
        second_layer_step(no_index, vertex_of(data_.second_node[step.from]));
      } else {
        first_layer_step(step.patch, data_.second_node[step.to], data_.second_node[step.from]);
      }
    }
  }

 private:
  /// A step back: two nodes of one layer and the patch of that layer between them; no_index: along edges.
  struct Step {
    Index from, to, patch;
  };

  /// From node `here` of a layer back to `goal`: each step leads through the patch and to the node with the
  /// least sum of the step's length and that node's distance from the goal, which must decrease from node to
  /// node. `lines(patch row, lengths, rests)` reads both for all nodes of a patch. Adds to back_.
  template <class FromGoal, class Lines>
  void walk(const PatchLayer& layer, Index here, Index goal, double favour_goal, FromGoal&& from_goal,
            Lines&& lines) {
    // This loop ends: each node is the goal or nearer to it than the previous one.
    while (here != goal) {
      const double at_here = from_goal(here);
      Step next{here, goal, no_index};  // along edges if no patch leads on
      double best = unreachable;
      for (const PatchRow& at : layer.patches_of(here)) {
        lines(at, step_, rest_);
        const auto nodes = layer.nodes(at.patch);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          const bool is_goal = nodes[i] == goal;
          const double rest = is_goal ? 0.0 : rest_[i];
          const double sum = rest + static_cast<double>(step_[i]);
          if (!(sum < best * (is_goal ? favour_goal : 1.0)) || nodes[i] == here || !(rest < at_here))
            continue;
          best = sum;
          next.to = nodes[i];
          next.patch = at.patch;
        }
      }
      back_.push_back(next);
      here = next.to;
    }
  }

  Index vertex_of(Index second_node) const { return data_.second.node_vertex[second_node]; }
  Index first_row(Index parent, Index second_node) const {
    const Index node = data_.first.vertex_node[vertex_of(second_node)];
    return node == no_index ? no_index : data_.first.row_of(node, parent);
  }
  double from_row(Index parent, Index row, Index second_node) const {
    const Index column = data_.column_in_parent(parent, second_node);
    return column == no_index ? unreachable : data_.first.distance(parent, row, column);
  }

  const IndexData& data_;
  PathChain& chain_;
  std::vector<Step> back_;
  std::vector<float> step_;
  std::vector<double> rest_;
};

}  // namespace

PathChain chain_of_route(const IndexData& data, const GraphRoute& route, Index source, Index target,
                         Index source_patch, Index target_patch) {
  PathChain chain;
  chain.source = source;
  if (route.nodes.empty()) return chain;
  ChainBuilder builder(data, chain);
  auto vertex_of = [&](Index node) { return data.second.node_vertex[node]; };
  if (vertex_of(route.nodes.front()) != source) {
    builder.second_layer_step(source_patch != no_index ? source_patch : data.home_patch[source],
                              vertex_of(route.nodes.front()));
  }
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    const Index a = route.nodes[i];
    const Index b = route.nodes[i + 1];
    const Leg leg = route.legs[i];
    switch (leg.table()) {
      case Leg::Table::transit:
        builder.transit_table_step(a, b);
        break;
      case Leg::Table::first:
        builder.first_layer_step(leg.patch(), a, b);
        break;
      case Leg::Table::second:
        builder.second_layer_step(leg.patch(), vertex_of(b));
        break;
    }
  }
  if (vertex_of(route.nodes.back()) != target) {
    builder.second_layer_step(target_patch != no_index ? target_patch : data.home_patch[target], target);
  }
  return chain;
}

}  // namespace vorogeo
