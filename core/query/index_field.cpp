// The steps of a field from an index, and the values read from it.
#include "query/index_field.h"

#include <algorithm>

#include "support/error.h"

namespace vorogeo {

/// Separates the sources on the inner surface from isolated ones. All are checked before anything changes.
void IndexField::take_sources(std::span<const ExactSource> given, double max_distance) {
  if (given.empty()) throw InvalidInput("There is no source: give at least one.");
  require_limit(max_distance);
  sources_.clear();
  number_.clear();
  isolated_.clear();
  const std::vector<ExactSource> checked = validated(*data_.mesh, given);
  for (std::size_t i = 0; i < checked.size(); ++i) {
    const auto& [point, offset] = checked[i];
    if (offset > max_distance) continue;
    if (point.is_vertex() && data_.surface.vertex[point.vertex] == no_index) {
      isolated_.push_back({static_cast<Index>(i), checked[i]});
      continue;
    }
    sources_.push_back({data_.surface.inner_point(point), offset});
    number_.push_back(static_cast<Index>(i));
  }
}

void IndexField::run(std::span<const ExactSource> sources, double max_distance, int threads,
                     bool wants_labels, const TangentFrame* directions) {
  take_sources(sources, max_distance);
  full_turn_ = directions != nullptr ? directions->full_turn() : 0.0;
  leg_.assign(directions != nullptr ? data_.surface.place_count() : 0, no_leg);
  distance_.assign(data_.surface.place_count(), unreachable);
  if (wants_labels) label_.assign(data_.surface.place_count(), no_index);
  if (sources_.empty()) return;
  near_.run(sources_, max_distance, directions);
  std::vector<BorderField::Seed> seeds;
  near_.for_each_reached_node([&](Index node, double distance, Index source) {
    if (directions == nullptr) {
      seeds.push_back({node, distance, number_[source]});
    } else if (near_.on_rim(node)) {
      const SurfacePoint at = data_.surface.surface_point(data_.second.node_place[node]);
      seeds.push_back({node, distance, number_[source], near_.solver().first_leg(at)});
    }
  });
  borders_.reset(seeds, max_distance, threads, full_turn_);
  const BorderDistances border = borders_.border();
  const auto is_reached = [&](Index node) { return border.distance[node] < unreachable; };
  parallel_for(data_.first.patch_count, threads, {}, "", [&](std::size_t item, int worker) {
    const auto parent = static_cast<Index>(item);
    FieldSweep& sweep = sweeps_.of(worker);
    borders_.fill(parent, sweep);
    for (Index p : data_.children(parent)) {
      if (std::ranges::none_of(data_.second.nodes(p), is_reached)) continue;
      const auto found = sweep.sweep(data_.second, border, p);
      take_sweep(p, found, sweep, wants_labels);
    }
  });
  if (wants_labels) {
    // The border node on each vertex's path leads to the source.
    node_label_.assign(data_.second.node_count(), no_index);
    for (Index& label : label_) {
      if (label != no_index) label = label_of_node(label);
    }
  }
  near_.for_each_held([&](Index v) { return distance_[v]; },
                      [&](Index v, double exact) {
                        distance_[v] = exact;
                        if (wants_labels) label_[v] = number_[near_.solver().nearest_source(v)];
                        if (directions != nullptr) leg_[v] = near_.solver().first_leg(v);
                      });
}

void IndexField::take_sweep(Index patch, std::span<const double> found, const FieldSweep& sweep,
                            bool labels) {
  const auto nodes = data_.second.nodes(patch);
  const auto members = data_.second.members(patch);
  for (std::size_t i = 0; i < members.size(); ++i) {
    // A border node belongs to several patches: its home patch writes it.
    if (data_.home_patch[members[i]] != patch) continue;
    distance_[members[i]] = found[i];
    if (!leg_.empty()) leg_[members[i]] = sweep.first_legs()[i];
    if (!labels) continue;
    const Index row = i < nodes.size() ? static_cast<Index>(i) : sweep.crossing_rows()[i];
    label_[members[i]] = row == no_index ? no_index : nodes[row];
  }
}

/// Follows the predecessors of a node back to where a source's wave began, and remembers the answer.
Index IndexField::label_of_node(Index node) {
  const auto predecessor = borders_.border().predecessor;
  passed_.clear();
  Index at = node;
  while (at >= 0 && node_label_[at] == no_index && passed_.size() <= predecessor.size()) {
    passed_.push_back(at);
    at = predecessor[at];
  }
  Index found = no_index;
  if (at >= 0) {
    found = node_label_[at];
  } else if (at < no_index) {
    found = BoundaryDijkstra::source_name(0) - at;
  }
  for (Index n : passed_) node_label_[n] = found;
  return found;
}

/// The source with the least offset at a vertex without a face; null if there is none.
const IndexField::Numbered* IndexField::isolated_at(Index vertex) const {
  const Numbered* least = nullptr;
  for (const Numbered& one : isolated_) {
    if (one.second.point.vertex != vertex) continue;
    if (least == nullptr || one.second.offset < least->second.offset) least = &one;
  }
  return least;
}

double IndexField::distance(Index vertex) const {
  const Index inner = data_.surface.vertex[vertex];
  if (inner != no_index) return distance_[inner];
  const Numbered* source = isolated_at(vertex);
  return source != nullptr ? source->second.offset : unreachable;
}

Index IndexField::nearest_source(Index vertex) const {
  const Index inner = data_.surface.vertex[vertex];
  if (inner != no_index) return label_[inner];
  const Numbered* source = isolated_at(vertex);
  return source != nullptr ? source->first : no_index;
}

double IndexField::first_leg(Index vertex) const {
  const Index inner = data_.surface.vertex[vertex];
  return inner != no_index && distance_[inner] < unreachable ? leg_[inner] : no_leg;
}

double IndexField::first_leg(const SurfacePoint& user) const {
  if (user.is_vertex()) return first_leg(user.vertex);
  const SurfacePoint point = data_.surface.inner_point(user);
  bool in_halo = false;
  for_each_face_at(*data_.surface.mesh, point, [&](Index face, const std::array<double, 3>&) {
    in_halo = in_halo || near_.halo().mask()[face] != 0;
  });
  if (in_halo) {
    const double exact = near_.solver().distance(point);
    if (exact < unreachable && exact <= distance(user)) return near_.solver().first_leg(point);
  }
  // As at a border: over the corner with the least sum, or a side at it that the straight line crosses.
  const FacePiece piece(data_.surface, point.face, point.barycentric);
  const std::array<double, 3> to_corner = distances_in_triangle(piece.length, piece.weights);
  std::array<double, 3> from_source{};
  int least = 0;
  for (int i : {0, 1, 2}) {
    from_source[i] = distance_[piece.place[i]];
    if (from_source[i] + to_corner[i] < from_source[least] + to_corner[least]) least = i;
  }
  BorderCrossing at{piece.place[least]};
  for (int step : {1, 2}) {
    const int other = (least + step) % 3;
    const double side = piece.length[step == 1 ? least : other];
    at.offer(piece.place[other],
             straight_crossing<double>(from_source[least], to_corner[least],
                                       {from_source[other], to_corner[other], side}, 0.0));
  }
  return FirstLegs{leg_, full_turn_}.across(at);
}

double IndexField::distance(const SurfacePoint& user) const {
  if (user.is_vertex()) return distance(user.vertex);
  if (sources_.empty()) return unreachable;
  const SurfacePoint point = data_.surface.inner_point(user);
  double by_index = unreachable;
  bool inside = false;
  bool in_halo = false;
  for_each_face_at(*data_.surface.mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    const FacePiece piece(data_.surface, face, weights);
    const auto& [a, b, c] = piece.place;
    by_index = std::min(by_index, piece.distance({distance_[a], distance_[b], distance_[c]}));
    inside = inside || near_.inside(face);
    in_halo = in_halo || near_.halo().mask()[face] != 0;
  });
  if (!in_halo) return by_index;
  const double exact = near_.solver().distance(point);
  return near_.holds(exact, by_index, inside) ? exact : by_index;
}

}  // namespace vorogeo
