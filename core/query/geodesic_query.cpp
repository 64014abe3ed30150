// The steps of a field, and the results read from them; pairs by way of their routes.
#include "query/geodesic_query.h"

#include <string>

#include "index/index_data.h"
#include "support/error.h"

namespace vorogeo {

GeodesicQuery::GeodesicQuery(std::shared_ptr<const GeodesicIndex> index, int threads)
    : index_(std::move(index)),
      data_(index_->data()),
      most_threads_(resolve_thread_count(threads)),
      threads_(most_threads_),
      sweeps_(most_threads_) {}

void GeodesicQuery::check(Index vertex, const char* role) const {
  if (vertex >= 0 && vertex < data_.mesh->vertex_count()) return;
  throw InvalidInput(std::string(role) + " vertex " + std::to_string(vertex) +
                     " does not exist: the mesh has vertices 0 to " +
                     std::to_string(data_.mesh->vertex_count() - 1) + ".");
}

double GeodesicQuery::distance(Index source, Index target) {
  check(source, "Source");
  check(target, "Target");
  if (source == target) return 0.0;
  const Index a = data_.surface.vertex[source];
  const Index b = data_.surface.vertex[target];
  if (a == no_index || b == no_index || data_.mesh->component(source) != data_.mesh->component(target)) {
    return unreachable;
  }
  if (a == b) return 0.0;
  if (!pairs_) pairs_.emplace(data_);
  return pairs_->distance(a, b);
}

// ---- Fields

/// Separates the sources on the inner surface from isolated ones. All are checked before anything changes.
void GeodesicQuery::take_sources(std::span<const ExactSource> given, double max_distance) {
  if (given.empty()) throw InvalidInput("There is no source; give at least one.");
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

void GeodesicQuery::sweep(Index first_layer_patch, FieldSweep& sweep, bool labels) {
  borders_->fill(first_layer_patch, sweep);
  const BorderDistances border = borders_->border();
  for (Index p : data_.children(first_layer_patch)) {
    const auto nodes = data_.second.nodes(p);
    if (std::ranges::all_of(nodes, [&](Index node) { return border.distance[node] == unreachable; }))
      continue;
    const auto found = sweep.sweep(data_.second, border, p);
    const auto rows = sweep.crossing_rows();
    const auto members = data_.second.members(p);
    for (std::size_t i = 0; i < members.size(); ++i) {
      // A border node belongs to several patches: its home patch writes it.
      if (data_.home_patch[members[i]] != p) continue;
      distance_[members[i]] = found[i];
      if (!labels) continue;
      const Index row = i < nodes.size() ? static_cast<Index>(i) : rows[i];
      label_[members[i]] = row == no_index ? no_index : nodes[row];
    }
  }
}

/// Follows the predecessors of a node back to where a source's wave began, and remembers the answer.
Index GeodesicQuery::label_of_node(Index node) {
  const auto predecessor = borders_->border().predecessor;
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

/// The steps of a field. Fills in distance_ and, if they are wanted, label_.
void GeodesicQuery::run(std::span<const ExactSource> given, double max_distance, bool wants_labels) {
  take_sources(given, max_distance);
  distance_.assign(data_.surface.place_count(), unreachable);
  if (wants_labels) label_.assign(data_.surface.place_count(), no_index);
  if (sources_.empty()) return;
  if (!near_) {
    near_.emplace(data_);
    borders_.emplace(data_);
  }
  near_->run(sources_, max_distance);
  std::vector<BorderField::Seed> seeds;
  near_->for_each_reached_node([&](Index node, double distance, Index source) {
    seeds.push_back({node, distance, number_[source]});
  });
  borders_->reset(seeds, max_distance, threads_);
  parallel_for(static_cast<std::size_t>(data_.first.patch_count), threads_, {}, "",
               [&](std::size_t parent, int worker) {
                 sweep(static_cast<Index>(parent), sweeps_.of(worker), wants_labels);
               });
  if (wants_labels) {
    // The border node on each vertex's path leads to the source.
    node_label_.assign(data_.second.node_count(), no_index);
    for (Index& label : label_) {
      if (label != no_index) label = label_of_node(label);
    }
  }
  near_->for_each_held([&](Index v) { return distance_[v]; },
                       [&](Index v, double exact) {
                         distance_[v] = exact;
                         if (wants_labels) label_[v] = number_[near_->solver().nearest_source(v)];
                       });
}

/// After a run.
double GeodesicQuery::distance_at(const SurfacePoint& user) const {
  if (user.is_vertex() && data_.surface.vertex[user.vertex] == no_index) {
    double least = unreachable;
    for (const auto& [place, one] : isolated_) {
      if (one.point.vertex == user.vertex) least = std::min(least, one.offset);
    }
    return least;
  }
  if (sources_.empty()) return unreachable;
  const SurfacePoint point = data_.surface.inner_point(user);
  if (point.is_vertex()) return distance_[point.vertex];
  const NearField& near = *near_;
  double by_index = unreachable;
  bool inside = false;
  bool in_halo = false;
  for_each_face_at(*data_.surface.mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    const FacePiece piece(data_.surface, face, weights);
    const auto& [a, b, c] = piece.place;
    by_index = std::min(by_index, piece.distance({distance_[a], distance_[b], distance_[c]}));
    inside = inside || near.inside(face);
    in_halo = in_halo || near.halo().mask()[face] != 0;
  });
  if (!in_halo) return by_index;
  const double exact = near.solver().distance(point);
  return near.holds(exact, by_index, inside) ? exact : by_index;
}

std::vector<double> GeodesicQuery::field(std::span<const ExactSource> sources, double max_distance,
                                         std::vector<Index>* labels) {
  run(sources, max_distance, labels != nullptr);
  const Index count = data_.mesh->vertex_count();
  std::vector<double> field(count, unreachable);
  if (labels != nullptr) labels->assign(count, no_index);
  for (Index v = 0; v < count; ++v) {
    const Index inner = data_.surface.vertex[v];
    if (inner == no_index || !(distance_[inner] <= max_distance) || distance_[inner] == unreachable) continue;
    field[v] = distance_[inner];
    if (labels != nullptr) (*labels)[v] = label_[inner];
  }
  for (const auto& [place, one] : isolated_) {
    if (one.offset >= field[one.point.vertex]) continue;
    field[one.point.vertex] = one.offset;
    if (labels != nullptr) (*labels)[one.point.vertex] = place;
  }
  return field;
}

std::vector<double> GeodesicQuery::distance_field(std::span<const Index> sources, double max_distance) {
  for (const Index source : sources) check(source, "Source");
  return field(sources_at(sources), max_distance);
}

std::vector<double> GeodesicQuery::distances(std::span<const ExactSource> sources, const PointList& targets,
                                             double max_distance) {
  const PointList points = points_on(*data_.mesh, targets, "Target");
  run(sources, max_distance, false);
  std::vector<double> result;
  result.reserve(points.size());
  for (const SurfacePoint& point : points) {
    const double distance = distance_at(point);
    result.push_back(distance <= max_distance ? distance : unreachable);
  }
  return result;
}

}  // namespace vorogeo
