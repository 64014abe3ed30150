// Exact around the sources, from table to table beyond; labels follow the nodes back to their source.
#include "query/source_field.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "index/index_data.h"
#include "mesh/face_distance.h"
#include "query/border_field.h"
#include "query/near_field.h"
#include "query/work_points.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

struct SourceField::State {
  State(std::shared_ptr<const GeodesicIndex> shared_index, int requested_threads)
      : index(std::move(shared_index)),
        data(index->data()),
        threads(resolve_thread_count(requested_threads)),
        near(data),
        borders(data),
        sweeps(threads) {}

  void run(std::span<const ExactSource> sources, double max_distance, bool distances_only);
  void take_sources(std::span<const ExactSource> given, double max_distance);
  void add_starts();
  void sweep(Index first_layer_patch, FieldSweep& sweep);
  double distance_at(const SurfacePoint& user) const;
  Index source_of_node(Index node);

  std::shared_ptr<const GeodesicIndex> index;
  const IndexData& data;
  int threads;
  NearField near;
  BorderField borders;
  std::vector<FieldSweep> sweeps;
  std::vector<ExactSource> sources;  ///< in the work mesh
  std::vector<Index> number;         ///< of each in the caller's list
  /// Sources at vertices without a face, which the work mesh does not have, by their place in the list.
  std::vector<std::pair<Index, ExactSource>> lonely;
  std::vector<BorderField::Start> starts;
  std::vector<Index> node_source;
  std::vector<double> distance;  ///< by work vertex
  std::vector<Index> source;     ///< by work vertex; during the sweeps the border node on its way
};

SourceField::SourceField(std::shared_ptr<const GeodesicIndex> index, int threads)
    : state_(std::make_unique<State>(std::move(index), threads)) {}
SourceField::~SourceField() = default;
SourceField::SourceField(SourceField&&) noexcept = default;
SourceField& SourceField::operator=(SourceField&&) noexcept = default;

/// The near field reaches border nodes, from which the way goes on.
void SourceField::State::add_starts() {
  starts.clear();
  for (Index face : near.halo().faces()) {
    for (Index v : data.work.mesh->face_vertices(face)) {
      const Index node = data.second.vertex_node[v];
      const double found = near.solver().distance(v);
      if (node != no_index && found < unreachable) {
        starts.push_back({node, found, number[near.solver().nearest_source(v)]});
      }
    }
  }
  std::ranges::sort(starts, [](const auto& a, const auto& b) { return a.node < b.node; });
  const auto repeated =
      std::ranges::unique(starts, [](const auto& a, const auto& b) { return a.node == b.node; });
  starts.erase(repeated.begin(), repeated.end());
}

void SourceField::State::sweep(Index first_layer_patch, FieldSweep& sweep) {
  borders.fill(first_layer_patch, sweep);
  const NodeRange children = borders.children(first_layer_patch);
  for (Index p = children.begin; p < children.end; ++p) {
    const auto found = sweep.sweep(data.second, borders.border(), p);
    const auto rows = sweep.crossing_rows();
    const auto members = data.second.members(p);
    const auto nodes = data.second.nodes(p);
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (data.home_patch[members[i]] != p || !(found[i] < unreachable)) continue;
      distance[members[i]] = found[i];
      const Index row = i < nodes.size() ? static_cast<Index>(i) : rows[i];
      source[members[i]] = row == no_index ? no_index : nodes[row];
    }
  }
}

/// Follows the nodes before one back to where a source's wave began, and remembers the answer.
Index SourceField::State::source_of_node(Index node) {
  const auto before = borders.border().before;
  std::vector<Index> passed;
  Index at = node;
  while (at >= 0 && node_source[at] == no_index && passed.size() <= before.size()) {
    passed.push_back(at);
    at = before[at];
  }
  Index found = no_index;
  if (at >= 0) {
    found = node_source[at];
  } else if (at < no_index) {
    found = BorderSearch::wave_name(0) - at;
  }
  for (Index n : passed) node_source[n] = found;
  return found;
}

/// Sorts the sources into those of the work mesh and lonely ones.
void SourceField::State::take_sources(std::span<const ExactSource> given, double max_distance) {
  if (given.empty()) throw InvalidInput("There is no source; give at least one.");
  if (!(max_distance >= 0.0)) {
    throw InvalidInput("The greatest distance is " + std::to_string(max_distance) +
                       "; it must be at least 0.");
  }
  sources.clear();
  number.clear();
  lonely.clear();
  for (std::size_t i = 0; i < given.size(); ++i) {
    const ExactSource& one = given[i];
    if (!(one.offset >= 0.0 && std::isfinite(one.offset))) {
      throw InvalidInput("Source " + std::to_string(i) + " has the offset " + std::to_string(one.offset) +
                         "; it must be a finite number of at least 0.");
    }
    const SurfacePoint point = validated(*data.mesh, one.point);
    if (one.offset > max_distance) continue;
    if (point.is_vertex() && data.work.work_vertex[point.vertex] == no_index) {
      lonely.push_back({static_cast<Index>(i), {point, one.offset}});
      continue;
    }
    sources.push_back({work_point(data, point), one.offset});
    number.push_back(static_cast<Index>(i));
  }
}

/// Fills distance and source.
void SourceField::State::run(std::span<const ExactSource> given, double max_distance, bool distances_only) {
  take_sources(given, max_distance);
  distance.assign(data.work.mesh->vertex_count(), unreachable);
  source.assign(data.work.mesh->vertex_count(), no_index);
  near.clear();
  if (sources.empty()) return;
  for (const ExactSource& one : sources) {
    for_each_face_at(*data.work.mesh, one.point, [&](Index face, const std::array<double, 3>&) {
      near.add(data.work.second_layer[face]);
    });
  }
  near.run(sources, max_distance, distances_only);
  add_starts();
  borders.start(starts, max_distance);
  parallel_for(static_cast<std::size_t>(data.first.patch_count), threads, {}, "",
               [&](std::size_t parent, int worker) { sweep(static_cast<Index>(parent), sweeps[worker]); });
  node_source.assign(data.second.node_count(), no_index);
  for (Index& of : source) {
    if (of != no_index) of = source_of_node(of);
  }
  near.for_each_held([&](Index v) { return distance[v]; },
                     [&](Index v, double exact) {
                       distance[v] = exact;
                       source[v] = number[near.solver().nearest_source(v)];
                     });
}

/// After run() with windows kept.
double SourceField::State::distance_at(const SurfacePoint& user) const {
  if (user.is_vertex() && data.work.work_vertex[user.vertex] == no_index) {
    double least = unreachable;
    for (const auto& [place, one] : lonely) {
      if (one.point.vertex == user.vertex) least = std::min(least, one.offset);
    }
    return least;
  }
  if (sources.empty()) return unreachable;
  const SurfacePoint point = work_point(data, user);
  if (point.is_vertex()) return distance[point.vertex];
  double by_index = unreachable;
  bool inside = false;
  bool in_halo = false;
  for_each_face_at(*data.work.mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    std::array<double, 3> corners{};
    for (int i = 0; i < 3; ++i) corners[i] = distance[data.work.mesh->face_vertices(face)[i]];
    by_index = std::min(by_index, distance_in_face(*data.work.mesh, face, weights, corners));
    inside = inside || near.inside(face);
    in_halo = in_halo || near.halo().mask()[face] != 0;
  });
  if (!in_halo) return by_index;
  const double exact = near.solver().distance(point);
  return near.holds(exact, by_index, inside) ? exact : by_index;
}

LabelledField SourceField::field(std::span<const ExactSource> sources, double max_distance) {
  State& state = *state_;
  const IndexData& data = state.data;
  state.run(sources, max_distance, true);
  LabelledField field;
  field.distance.assign(data.mesh->vertex_count(), unreachable);
  field.source.assign(data.mesh->vertex_count(), no_index);
  for (Index v = 0; v < data.mesh->vertex_count(); ++v) {
    const Index work = data.work.work_vertex[v];
    if (work == no_index || !(state.distance[work] <= max_distance)) continue;
    field.distance[v] = state.distance[work];
    field.source[v] = state.distance[work] < unreachable ? state.source[work] : no_index;
  }
  for (const auto& [place, one] : state.lonely) {
    if (one.offset >= field.distance[one.point.vertex]) continue;
    field.distance[one.point.vertex] = one.offset;
    field.source[one.point.vertex] = place;
  }
  return field;
}

std::vector<double> SourceField::distances(std::span<const ExactSource> sources, const PointList& targets,
                                           double max_distance) {
  State& state = *state_;
  const PointList points = points_on(*state.data.mesh, targets, "Target");
  state.run(sources, max_distance, points.only_vertices());
  std::vector<double> result;
  result.reserve(points.size());
  for (const SurfacePoint& point : points) {
    const double distance = state.distance_at(point);
    result.push_back(distance <= max_distance ? distance : unreachable);
  }
  return result;
}

}  // namespace vorogeo
