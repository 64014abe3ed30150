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

IndexedEnd::IndexedEnd(const IndexData& data, const SurfacePoint& user)
    : PathEnd(*data.surface.mesh, data.surface.inner_point(user)), place(point.vertex) {
  for_each_face_at(*data.surface.mesh, point, [&](Index face, const std::array<double, 3>&) {
    const Index at_face = data.surface.second_layer[face];
    if (std::ranges::find(patches, at_face) == patches.end()) patches.push_back(at_face);
  });
  if (point.is_vertex()) return;
  patch = patches.front();
  piece.emplace(data.surface, point.face, point.barycentric);
  const auto distances = distances_in_triangle(piece->length, piece->weights);
  const auto nearest = std::ranges::min_element(distances);
  to_place = *nearest;
  place = piece->place[nearest - distances.begin()];
}

bool are_near(const IndexData& data, const IndexedEnd& a, const IndexedEnd& b) {
  return std::ranges::any_of(a.patches, [&](Index p) {
    return std::ranges::any_of(b.patches,
                               [&](Index q) { return p == q || data.second.touching.touch(p, q); });
  });
}

RouteEnd route_end_of(const IndexData& data, const IndexedEnd& end) {
  RouteEnd result;
  if (!end.piece) {
    route_end(data, end.place, result);
    return result;
  }
  result.patch = end.patch;
  const auto nodes = data.second.nodes(result.patch);
  result.parents.push_back(data.partition.parent[result.patch]);
  std::array<Index, 3> column{};
  for (int k = 0; k < 3; ++k) column[k] = data.column_in_patch(result.patch, end.piece->place[k]);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::array<double, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      corners[k] = data.second.distance(result.patch, static_cast<Index>(i), column[k]);
    }
    const double distance = end.piece->distance(corners);
    if (distance < unreachable) result.seeds.push_back({nodes[i], distance});
  }
  return result;
}

// ---- A walk for each step of the chain

namespace {

/// Adds faces until the strip ends in `face`, past a place of this face and of the last one.
bool pass(const InnerSurface& surface, FaceStrip& strip, Index place, Index face) {
  const Mesh& mesh = *surface.mesh;
  if (surface.is_vertex(place)) return turn_around(mesh, strip, place, face);
  if (strip.last() == face) return true;
  const Index edge = surface.point_at(place).edge;
  auto side_of = [&](Index f) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh.edge_of(h) == edge) return h;
    }
    return no_index;
  };
  const HalfedgePair crossing{side_of(strip.last()), side_of(face)};
  if (crossing.exit == no_index || crossing.entry == no_index) return false;
  strip.crossings.push_back(crossing);
  return true;
}

}  // namespace

bool strip_along_chain(const IndexData& data, const PathChain& chain, FaceStrip& strip) {
  const Mesh& mesh = *data.surface.mesh;
  strip.first = strip.source.face;
  strip.crossings.clear();
  std::vector<StepWalk> walks;
  std::vector<std::uint8_t> forwards;
  walks.reserve(chain.steps.size());
  Index place = chain.source;
  for (const ChainStep& step : chain.steps) {
    forwards.push_back(step.patch == no_index || data.row_in_patch(step.patch, step.place) != no_index);
    walks.emplace_back(data, step.patch, forwards.back() ? place : step.place,
                       forwards.back() ? step.place : place);
    place = step.place;
  }
  std::vector<StepWalk*> going;
  for (StepWalk& walk : walks) going.push_back(&walk);
  // Each walk terminates (path_chain.h).
  while (!going.empty()) std::erase_if(going, [](StepWalk* walk) { return !walk->go_on(); });
  place = chain.source;
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
        pivot = first ? place : passed[at + 1].pivot;
      }
      if (strip.first == no_index) {
        strip.first = passed[at].face;
      } else if (exit != no_index) {
        strip.crossings.push_back({exit, entry});
      } else if (!pass(data.surface, strip, pivot, passed[at].face)) {
        return false;
      }
    }
    place = chain.steps[k].place;
  }
  if (strip.first == no_index) strip.first = Mesh::face_of(mesh.corners(strip.source.vertex).front());
  if (strip.target.is_vertex()) {
    const auto& last = mesh.face_vertices(strip.last());
    if (std::find(last.begin(), last.end(), strip.target.vertex) == last.end()) return false;
  } else if (!pass(data.surface, strip, place, strip.target.face)) {
    return false;
  }
  return true;
}

// ---- In each face the distances of two vertices are unfolded into the plane

namespace {

/// A walk is abandoned when it becomes this many times as long as it should be.
constexpr double longer = 1.1;

/// Of a walk that is not on an edge.
constexpr double off_the_edge = -1.0;

/// Calls visit(half-edge) for every face at an edge.
template <class Visit>
void for_each_side(const Mesh& mesh, Index edge, Visit&& visit) {
  const Index first = mesh.edge_halfedge(edge);
  Index h = first;
  do {
    visit(h);
    h = mesh.next_around_edge(h);
  } while (h != first);
}

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace

StepWalk::StepWalk(const IndexData& data, Index patch, Index start, Index goal)
    : data_(data),
      mesh_(*data.surface.mesh),
      geometry_(*data.geometry->windows),
      patch_(patch),
      row_(patch == no_index ? no_index : data.row_in_patch(patch, goal)),
      goal_(goal),
      goal_edge_(data.surface.is_vertex(goal) ? no_index : data.surface.point_at(goal).edge),
      place_(start) {
  passed_.reserve(64);
}

bool StepWalk::go_on() {
  switch (next_) {
    case Next::meet_place:
      meet_place();
      break;
    case Next::look_around:
      for_each_neighbour([&](Index vertex) { fetch_column(vertex); });
      next_ = Next::look_up_ring;
      break;
    case Next::look_up_ring:
      for_each_neighbour([&](Index vertex) { fetch_distance(vertex); });
      next_ = Next::leave_place;
      break;
    case Next::leave_place:
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

template <class Visit>
void StepWalk::for_each_neighbour(Visit&& visit) const {
  if (data_.surface.is_vertex(place_)) {
    for (Index corner : mesh_.corners(place_)) visit(mesh_.head(corner));
    return;
  }
  const Index edge = data_.surface.point_at(place_).edge;
  for (Index vertex : mesh_.edge_vertices(edge)) visit(vertex);
  for_each_side(mesh_, edge, [&](Index h) { visit(geometry_.frame[h].apex); });
}

void StepWalk::fetch_column(Index vertex) const {
  prefetch_line(&data_.second.place_node[vertex]);
  prefetch_line(&data_.home_patch[vertex]);
  prefetch_line(&data_.home_column[vertex]);
}

Index StepWalk::fetch_distance(Index vertex) const {
  const Index column = data_.column_in_patch(patch_, vertex);
  if (column != no_index) prefetch_line(&data_.second.column_of(patch_, column).entry(row_));
  return column;
}

void StepWalk::meet_place() {
  if (place_ == goal_) {
    next_ = Next::nothing;
    return;
  }
  if (row_ == no_index) {
    walk_along_edges();
    return;
  }
  if (data_.surface.is_vertex(place_)) {
    for (Index corner : mesh_.corners(place_)) {
      const Index opposite = Mesh::next_in_face(corner);
      prefetch_line(&geometry_.frame[opposite]);
      prefetch_line(&mesh_.face_vertices(Mesh::face_of(corner)));
      mesh_.prefetch_around_edge(opposite);
    }
  }
  next_ = Next::look_around;
}

void StepWalk::leave() {
  straight_from_ = passed_.size();
  at_last_ = distance(place_);
  expected_ = at_last_ * longer;
  faces_left_ = 4 * static_cast<std::size_t>(data_.second.member_count(patch_)) + 64;
  move_ =
      data_.surface.is_vertex(place_) ? leave_vertex(place_) : leave_point(data_.surface.point_at(place_));
  take_move({move_.face, no_index, no_index, place_});
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
  if (move_.place != no_index) {
    place_ = move_.place;
    next_ = Next::meet_place;
    return;
  }
  entry_ = mesh_.next_around_edge(move_.halfedge);
  prefetch_line(&geometry_.frame[entry_]);
  mesh_.prefetch_around_edge(entry_);
  next_ = Next::find_apex;
}

void StepWalk::walk_along_edges() {
  // From and to an end of the edge that a place is inside, through a face at this edge.
  auto vertex_at = [&](Index place) {
    return data_.surface.is_vertex(place) ? place
                                          : mesh_.edge_vertices(data_.surface.point_at(place).edge)[0];
  };
  auto pass_face_at = [&](Index place, Index pivot) {
    if (data_.surface.is_vertex(place)) return;
    const Index h = mesh_.edge_halfedge(data_.surface.point_at(place).edge);
    passed_.push_back({Mesh::face_of(h), no_index, no_index, pivot});
  };
  next_ = Next::nothing;
  std::vector<EdgeStep> path;
  if (!path_along_edges(mesh_, vertex_at(place_), vertex_at(goal_), path)) return;
  pass_face_at(place_, place_);
  for (const EdgeStep& step : path) {
    passed_.push_back({Mesh::face_of(step.halfedge), no_index, no_index, step.from});
  }
  pass_face_at(goal_, vertex_at(goal_));
  place_ = goal_;
}

double StepWalk::distance_at(Index column) const {
  return column == no_index ? unreachable : data_.second.distance(patch_, row_, column);
}

double StepWalk::distance(Index place) const { return distance_at(data_.column_in_patch(patch_, place)); }

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

StepWalk::Move StepWalk::to_goal_in_face(Index halfedge, double x) const {
  Move move;
  if (goal_edge_ == no_index) return move;
  const FaceFrame& frame = geometry_.frame[halfedge];
  const double length = mesh_.edge_length(mesh_.edge_of(halfedge));
  const double goal = data_.surface.point_at(goal_).position;
  const bool from_apex = x == off_the_edge;
  const PlanePoint from = from_apex ? PlanePoint{frame.apex_x, frame.apex_depth} : PlanePoint{x, 0.0};
  auto take = [&](const PlanePoint& at) {
    move = {length_of(at[0] - from[0], at[1] - from[1]), Mesh::face_of(halfedge), goal_};
  };
  if (mesh_.edge_of(halfedge) == goal_edge_) take({goal, 0.0});
  for (const bool first : {true, false}) {
    const Index side = first ? frame.first_side(halfedge) : frame.second_side(halfedge);
    if (mesh_.edge_of(side) != goal_edge_) continue;
    // From the corner that the side shares with the edge.
    const bool reversed = first ? frame.first_side_reversed : frame.second_side_reversed;
    const double part = goal / mesh_.edge_length(goal_edge_);
    const double along = reversed ? 1.0 - part : part;
    const double corner = first ? 0.0 : length;
    take({std::lerp(corner, frame.apex_x, along), along * frame.apex_depth});
  }
  return move;
}

StepWalk::Move StepWalk::leave_point(const EdgePoint& point) const {
  Move start;
  start.x = point.position;
  start.edge_length = mesh_.edge_length(point.edge);
  start.first = mesh_.edge_vertices(point.edge)[0];
  start.second = mesh_.edge_vertices(point.edge)[1];
  start.at_first = distance(start.first);
  start.at_second = distance(start.second);
  Move best;
  for_each_side(mesh_, point.edge, [&](Index h) {
    const Move move = cross(h, start, distance(geometry_.frame[h].apex));
    if (move.length < best.length) best = move;
  });
  return best;
}

StepWalk::Move StepWalk::leave_vertex(Index vertex) const {
  Move best;
  // Neighbours are consecutive in the fan: each is an end of two of the opposite edges.
  std::array<Index, 2> known{no_index, no_index};
  std::array<double, 2> at{unreachable, unreachable};
  for (Index corner : mesh_.corners(vertex)) {
    const Index opposite = Mesh::next_in_face(corner);
    const Index face = Mesh::face_of(corner);
    if (const Move move = to_goal_in_face(opposite, off_the_edge); move.place != no_index) return move;
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
  Move best = to_goal_in_face(halfedge, x);
  if (best.place != no_index) return best;
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

  void second_layer_step(Index patch, Index place) { chain_.steps.push_back({place, patch}); }

  /// From second-layer node a to b by the table of first-layer patch `parent`; one of them is on its border.
  void first_layer_step(Index parent, Index a, Index b) {
    const bool backwards = first_row(parent, a) == no_index;
    const Index fixed = first_row(parent, backwards ? b : a);
    if (fixed == no_index) {
      second_layer_step(no_index, place_of(b));
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
        prefetch_line(&data_.first.column_of(parent, columns[i]).entry(fixed));
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
        second_layer_step(back_[k].patch, place_of(back_[k].to));
      } else {
        const Step& step = back_[back_.size() - 1 - k];
        second_layer_step(step.patch, place_of(step.from));
      }
    }
  }

  /// From one first-layer node to another by the transit table; both are given by their second-layer nodes.
  void transit_table_step(Index a, Index b) {
    const Index goal = data_.first.place_node[place_of(a)];
    auto from_goal = [&](Index node) -> double { return data_.transit_table.distance(goal, node); };
    auto lines = [&](const PatchRow& at, std::vector<float>& length, std::vector<double>& rest) {
      const auto nodes = data_.first.nodes(at.patch);
      length.resize(nodes.size());
      rest.resize(nodes.size());
      data_.first.read_border(at.patch, at.row, length.data());
      for (std::size_t i = 0; i < nodes.size(); ++i) rest[i] = from_goal(nodes[i]);
    };
    back_.clear();
    walk(data_.first, data_.first.place_node[place_of(b)], goal, 1.0 + equal_sums, from_goal, lines);
    const std::vector<Step> steps(back_.rbegin(), back_.rend());
    for (const Step& step : steps) {
      if (step.patch == no_index) {
        second_layer_step(no_index, place_of(data_.second_node[step.from]));
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

  Index place_of(Index second_node) const { return data_.second.node_place[second_node]; }
  Index first_row(Index parent, Index second_node) const {
    const Index node = data_.first.place_node[place_of(second_node)];
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
  auto place_of = [&](Index node) { return data.second.node_place[node]; };
  if (place_of(route.nodes.front()) != source) {
    builder.second_layer_step(source_patch != no_index ? source_patch : data.home_patch[source],
                              place_of(route.nodes.front()));
  }
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    const Index a = route.nodes[i];
    const Index b = route.nodes[i + 1];
    const Leg leg = route.legs[i];
    switch (leg.table) {
      case Leg::Table::transit:
        builder.transit_table_step(a, b);
        break;
      case Leg::Table::first:
        builder.first_layer_step(leg.patch, a, b);
        break;
      case Leg::Table::second:
        builder.second_layer_step(leg.patch, place_of(b));
        break;
    }
  }
  if (place_of(route.nodes.back()) != target) {
    builder.second_layer_step(target_patch != no_index ? target_patch : data.home_patch[target], target);
  }
  return chain;
}

}  // namespace vorogeo
