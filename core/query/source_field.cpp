// Exact around the sources, from table to table beyond; labels follow the nodes back to their source.
#include "query/source_field.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "index/index_data.h"
#include "index/local_tables.h"
#include "query/border_field.h"
#include "query/work_points.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

/// As in GeodesicQuery: growth of the halo of the near field, and where a way outside it is believed.
constexpr double near_field_growth = 3.0;
constexpr double shorter_outside = 0.99;

}  // namespace

struct SourceField::State {
  State(std::shared_ptr<const GeodesicIndex> shared_index, int requested_threads)
      : index(std::move(shared_index)),
        data(index->data()),
        threads(resolve_thread_count(requested_threads)),
        solver(data.geometry),
        halo(*data.work.mesh, data.work.second_layer, data.second.patch_count),
        borders(data),
        sweeps(threads),
        is_near(data.second.patch_count, 0) {}

  void near_field(double max_distance);
  void sweep(Index first_layer_patch, FieldSweep& sweep, LabelledField& field);
  void join_near_field(LabelledField& field);
  Index source_of_node(Index node);

  std::shared_ptr<const GeodesicIndex> index;
  const IndexData& data;
  int threads;
  ExactSolver solver;
  Halo halo;
  BorderField borders;
  std::vector<FieldSweep> sweeps;
  std::vector<std::uint8_t> is_near;
  std::vector<ExactSource> sources;  ///< in the work mesh
  std::vector<Index> number;         ///< of each in the caller's list
  std::vector<Index> near;
  std::vector<BorderField::Start> starts;
  std::vector<Index> node_source;
  double certain = 0.0;
};

SourceField::SourceField(std::shared_ptr<const GeodesicIndex> index, int threads)
    : state_(std::make_unique<State>(std::move(index), threads)) {}
SourceField::~SourceField() = default;
SourceField::SourceField(SourceField&&) noexcept = default;
SourceField& SourceField::operator=(SourceField&&) noexcept = default;

void SourceField::State::near_field(double max_distance) {
  halo.surround(near, near_field_growth);
  std::vector<Index> targets;
  for (Index p : near) {
    targets.insert(targets.end(), data.second.members(p).begin(), data.second.members(p).end());
  }
  ExactLimits limits;
  limits.face_allowed = halo.mask();
  limits.targets = targets;
  limits.distances_only = true;
  limits.max_distance = max_distance;
  solver.run(sources, limits);
  certain = std::min(solver.settled_distance(), solver.barrier_distance());
  starts.clear();
  for (Index face : halo.faces()) {
    for (Index v : data.work.mesh->face_vertices(face)) {
      const Index node = data.second.vertex_node[v];
      const double distance = solver.distance(v);
      if (node != no_index && distance < unreachable) {
        starts.push_back({node, distance, number[solver.nearest_source(v)]});
      }
    }
  }
  std::ranges::sort(starts, [](const auto& a, const auto& b) { return a.node < b.node; });
  const auto repeated =
      std::ranges::unique(starts, [](const auto& a, const auto& b) { return a.node == b.node; });
  starts.erase(repeated.begin(), repeated.end());
}

/// Writes distances, and for now as the source of a vertex the border node on its way.
void SourceField::State::sweep(Index first_layer_patch, FieldSweep& sweep, LabelledField& field) {
  borders.fill(first_layer_patch, sweep);
  const NodeRange children = borders.children(first_layer_patch);
  for (Index p = children.begin; p < children.end; ++p) {
    const auto found = sweep.sweep(data.second, borders.border(), p);
    const auto rows = sweep.crossing_rows();
    const auto members = data.second.members(p);
    const auto nodes = data.second.nodes(p);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Index user = data.work.user_vertex[members[i]];
      if (user == no_index || data.home_patch[members[i]] != p || !(found[i] < unreachable)) continue;
      field.distance[user] = found[i];
      const Index row = i < nodes.size() ? static_cast<Index>(i) : rows[i];
      field.source[user] = row == no_index ? no_index : nodes[row];
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
  Index source = no_index;
  if (at >= 0) {
    source = node_source[at];
  } else if (at < no_index) {
    source = BorderSearch::wave_name(0) - at;
  }
  for (Index n : passed) node_source[n] = source;
  return source;
}

void SourceField::State::join_near_field(LabelledField& field) {
  for (Index face : halo.faces()) {
    const bool inside = is_near[data.work.second_layer[face]] != 0;
    for (Index v : data.work.mesh->face_vertices(face)) {
      const Index user = data.work.user_vertex[v];
      if (user == no_index) continue;
      const double exact = solver.distance(v);
      if (exact == unreachable) continue;
      double& distance = field.distance[user];
      // Inside the patches the solver's distance holds unless a way outside is clearly shorter.
      const bool holds =
          exact <= certain || exact <= distance || (inside && distance >= shorter_outside * exact);
      if (!holds) continue;
      distance = exact;
      field.source[user] = number[solver.nearest_source(v)];
    }
  }
}

LabelledField SourceField::field(std::span<const ExactSource> sources, double max_distance) {
  State& state = *state_;
  const IndexData& data = state.data;
  if (sources.empty()) throw InvalidInput("There is no source; give at least one.");
  if (!(max_distance >= 0.0)) {
    throw InvalidInput("The greatest distance is " + std::to_string(max_distance) +
                       "; it must be at least 0.");
  }
  LabelledField field;
  field.distance.assign(data.mesh->vertex_count(), unreachable);
  field.source.assign(data.mesh->vertex_count(), no_index);
  state.sources.clear();
  state.number.clear();
  state.near.clear();
  std::vector<std::pair<Index, Index>> lonely;  // vertices without a face, and their place in the list
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const ExactSource& source = sources[i];
    if (!(source.offset >= 0.0 && std::isfinite(source.offset))) {
      throw InvalidInput("Source " + std::to_string(i) + " has the offset " + std::to_string(source.offset) +
                         "; it must be a finite number of at least 0.");
    }
    const SurfacePoint point = validated(*data.mesh, source.point);
    if (point.is_vertex() && data.work.work_vertex[point.vertex] == no_index) {
      lonely.emplace_back(point.vertex, static_cast<Index>(i));
      continue;
    }
    if (source.offset > max_distance) continue;
    state.sources.push_back({work_point(data, point), source.offset});
    state.number.push_back(static_cast<Index>(i));
  }
  for (const auto& [vertex, place] : lonely) {
    const double offset = sources[place].offset;
    if (offset > max_distance || offset >= field.distance[vertex]) continue;
    field.distance[vertex] = offset;
    field.source[vertex] = place;
  }
  if (state.sources.empty()) return field;

  std::fill(state.is_near.begin(), state.is_near.end(), 0);
  for (const ExactSource& source : state.sources) {
    for_each_face_at(*data.work.mesh, source.point, [&](Index face, const std::array<double, 3>&) {
      std::uint8_t& marked = state.is_near[data.work.second_layer[face]];
      if (marked == 0) state.near.push_back(data.work.second_layer[face]);
      marked = 1;
    });
  }
  state.near_field(max_distance);
  state.borders.start(state.starts, max_distance);
  parallel_for(static_cast<std::size_t>(data.first.patch_count), state.threads, {}, "",
               [&](std::size_t parent, int worker) {
                 state.sweep(static_cast<Index>(parent), state.sweeps[worker], field);
               });
  state.node_source.assign(data.second.node_count(), no_index);
  for (std::size_t v = 0; v < field.source.size(); ++v) {
    if (field.source[v] != no_index && data.work.work_vertex[v] != no_index) {
      field.source[v] = state.source_of_node(field.source[v]);
    }
  }
  state.join_near_field(field);
  for (std::size_t v = 0; v < field.distance.size(); ++v) {
    if (field.distance[v] <= max_distance) continue;
    field.distance[v] = unreachable;
    field.source[v] = no_index;
  }
  return field;
}

}  // namespace vorogeo
