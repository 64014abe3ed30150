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
  const Index a = data_.work.work_vertex[source];
  const Index b = data_.work.work_vertex[target];
  if (a == no_index || b == no_index || data_.mesh->component(source) != data_.mesh->component(target)) {
    return unreachable;
  }
  if (a == b) return 0.0;
  if (!pairs_) pairs_.emplace(data_);
  return pairs_->distance(a, b);
}

// ---- Fields

/// Separates the sources on the work mesh from isolated ones. All are checked before anything changes.
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
    if (point.is_vertex() && data_.work.work_vertex[point.vertex] == no_index) {
      isolated_.push_back({static_cast<Index>(i), checked[i]});
      continue;
    }
    sources_.push_back({work_point(data_, point), offset});
    number_.push_back(static_cast<Index>(i));
  }
}

/// Takes the border nodes that the near field reached as seeds.
void GeodesicQuery::find_seeds() {
  const LocalSolver& solver = near_->solver();
  seeds_.clear();
  for (Index face : near_->halo().faces()) {
    for (Index v : data_.work.mesh->face_vertices(face)) {
      const Index node = data_.second.vertex_node[v];
      if (node == no_index) continue;
      const double found = solver.distance(v);
      if (found < unreachable) seeds_.push_back({node, found, number_[solver.nearest_source(v)]});
    }
  }
  std::ranges::sort(seeds_, {}, &BorderField::Seed::node);
  const auto repeated = std::ranges::unique(seeds_, {}, &BorderField::Seed::node);
  seeds_.erase(repeated.begin(), repeated.end());
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

/// Replaces the border node on each vertex's path by the source to which it leads.
void GeodesicQuery::find_labels() {
  node_label_.assign(data_.second.node_count(), no_index);
  for (Index& label : label_) {
    if (label != no_index) label = label_of_node(label);
  }
}

/// The steps of a field. Fills in distance_ and, if they are wanted, label_.
void GeodesicQuery::run(std::span<const ExactSource> given, double max_distance, Wanted wanted) {
  take_sources(given, max_distance);
  distance_.assign(data_.work.mesh->vertex_count(), unreachable);
  if (wanted.labels) label_.assign(data_.work.mesh->vertex_count(), no_index);
  if (sources_.empty()) return;
  if (!near_) {
    near_.emplace(data_);
    borders_.emplace(data_);
  }
  near_->run(sources_, max_distance, !wanted.windows);
  find_seeds();
  borders_->reset(seeds_, max_distance, threads_);
  parallel_for(static_cast<std::size_t>(data_.first.patch_count), threads_, {}, "",
               [&](std::size_t parent, int worker) {
                 sweep(static_cast<Index>(parent), sweeps_.of(worker), wanted.labels);
               });
  if (wanted.labels) find_labels();
  near_->for_each_held([&](Index v) { return distance_[v]; },
                       [&](Index v, double exact) {
                         distance_[v] = exact;
                         if (wanted.labels) label_[v] = number_[near_->solver().nearest_source(v)];
                       });
}

/// After a run that kept its windows, if the point is in a face.
double GeodesicQuery::distance_at(const SurfacePoint& user) const {
  if (user.is_vertex() && data_.work.work_vertex[user.vertex] == no_index) {
    double least = unreachable;
    for (const auto& [place, one] : isolated_) {
      if (one.point.vertex == user.vertex) least = std::min(least, one.offset);
    }
    return least;
  }
  if (sources_.empty()) return unreachable;
  const SurfacePoint point = work_point(data_, user);
  if (point.is_vertex()) return distance_[point.vertex];
  const NearField& near = *near_;
  double by_index = unreachable;
  bool inside = false;
  bool in_halo = false;
  for_each_face_at(*data_.work.mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    std::array<double, 3> corners{};
    for (int i = 0; i < 3; ++i) corners[i] = distance_[data_.work.mesh->face_vertices(face)[i]];
    by_index = std::min(by_index, distance_in_face(*data_.work.mesh, face, weights, corners));
    inside = inside || near.inside(face);
    in_halo = in_halo || near.halo().mask()[face] != 0;
  });
  if (!in_halo) return by_index;
  const double exact = near.solver().distance(point);
  return near.holds(exact, by_index, inside) ? exact : by_index;
}

std::vector<double> GeodesicQuery::field(std::span<const ExactSource> sources, double max_distance,
                                         std::vector<Index>* labels) {
  run(sources, max_distance, {.windows = false, .labels = labels != nullptr});
  const Index count = data_.mesh->vertex_count();
  std::vector<double> field(count, unreachable);
  if (labels != nullptr) labels->assign(count, no_index);
  for (Index v = 0; v < count; ++v) {
    const Index work = data_.work.work_vertex[v];
    if (work == no_index || !(distance_[work] <= max_distance) || distance_[work] == unreachable) continue;
    field[v] = distance_[work];
    if (labels != nullptr) (*labels)[v] = label_[work];
  }
  for (const auto& [place, one] : isolated_) {
    if (one.offset >= field[one.point.vertex]) continue;
    field[one.point.vertex] = one.offset;
    if (labels != nullptr) (*labels)[one.point.vertex] = place;
  }
  return field;
}

std::vector<double> GeodesicQuery::distance_field(std::span<const Index> sources, double max_distance) {
  std::vector<ExactSource> points;
  points.reserve(sources.size());
  for (Index source : sources) {
    check(source, "Source");
    points.push_back({SurfacePoint::at_vertex(source)});
  }
  return field(points, max_distance);
}

std::vector<double> GeodesicQuery::distances(std::span<const ExactSource> sources, const PointList& targets,
                                             double max_distance) {
  const PointList points = points_on(*data_.mesh, targets, "Target");
  run(sources, max_distance, {.windows = !points.only_vertices(), .labels = false});
  std::vector<double> result;
  result.reserve(points.size());
  for (const SurfacePoint& point : points) {
    const double distance = distance_at(point);
    result.push_back(distance <= max_distance ? distance : unreachable);
  }
  return result;
}

}  // namespace vorogeo
