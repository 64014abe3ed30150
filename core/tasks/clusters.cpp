// Points divided into clusters around centres: k-means and k-medoids.
#include "tasks/clusters.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "mesh/mesh_input.h"
#include "support/memory.h"
#include "support/parallel.h"
#include "support/vertex_search.h"
#include "tasks/spread_points.h"

namespace vorogeo {

namespace {

/// The typical number of rounds until clusters of points have settled.
constexpr double usual_rounds = 10.0;

void require_enough(const Mesh& mesh, Index count, const PointList& points, std::span<const double> weights) {
  std::set<Index> components;
  Index weighted = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > 0.0)) continue;
    ++weighted;
    components.insert(component_of(mesh, points[i]));
  }
  if (count < 1 || count > weighted) {
    throw InvalidInput("There are " + std::to_string(weighted) + " points to be divided into " +
                       std::to_string(count) + " clusters; ask for 1 to " + std::to_string(weighted) + ".");
  }
  if (count < static_cast<Index>(components.size())) {
    throw InvalidInput(
        "The points lie on " + std::to_string(components.size()) +
        " components, and no path leads from one to another; ask for at least as many clusters.");
  }
}

/// k-means++: positions of points, each chosen by its weight times the power of its distance from the seeds
/// before. lower(seed, farthest, nearest): lowers `nearest` to the distances from one more seed, of which
/// those above `farthest` need not be found.
template <class Lower>
std::vector<Index> seeds(Index count, std::span<const double> weights, Power power, std::uint64_t seed,
                         const Progress& progress, const Lower& lower) {
  std::mt19937_64 random(seed);
  std::vector<double> nearest(weights.size(), unreachable), share(weights.size());
  std::vector<Index> chosen;
  double farthest = unreachable;
  while (static_cast<Index>(chosen.size()) < count) {
    // Points on a component without a seed are chosen first.
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const bool comes = weights[i] > 0.0 && (farthest < unreachable || nearest[i] == unreachable);
      share[i] = comes ? weights[i] * (farthest < unreachable ? powered(nearest[i], power) : 1.0) : 0.0;
    }
    const double sum = std::accumulate(share.begin(), share.end(), 0.0);
    if (!(sum > 0.0)) {
      throw InvalidInput("Only " + std::to_string(chosen.size()) +
                         " points differ from one another, too few for " + std::to_string(count) +
                         " clusters; ask for fewer.");
    }
    double left = sum * static_cast<double>(random() >> 11U) * 0x1p-53;
    Index next = no_index;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (!(share[i] > 0.0)) continue;
      next = static_cast<Index>(i);
      if ((left -= share[i]) < 0.0) break;
    }
    chosen.push_back(next);
    lower(next, farthest, nearest);
    farthest = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] > 0.0) farthest = std::max(farthest, nearest[i]);
    }
    progress.report(static_cast<double>(chosen.size()) / count, "Seeds of clusters");
  }
  return chosen;
}

/// Lowers the vertices' distances along edges to those from one more vertex.
void lower_along_edges(const Mesh& mesh, Index from, std::vector<double>& distance) {
  VertexSearch search(std::move(distance), std::array{mesh.representative(from)});
  for (Index v = search.settle_next(); v != no_index; v = search.settle_next()) {
    mesh.for_each_side_at(v, [&](Index side, Index other) {
      search.lower(other, search.distance(v) + mesh.edge_length(mesh.edge_of(side)));
    });
  }
  distance = search.distances();
  if (!mesh.has_merged_vertices()) return;
  for (Index v = 0; v < mesh.vertex_count(); ++v) distance[v] = distance[mesh.representative(v)];
}

/// Centres of clusters of points, with their distances from all.
class PointClusters {
 public:
  PointClusters(Surface& surface, Workers& workers, const PointList& points, std::span<const double> weights,
                Power power, const std::vector<Index>& seeds)
      : surface_(surface), workers_(workers), points_(points), weights_(weights), power_(power) {
    require_memory(static_cast<double>(seeds.size()) * static_cast<double>(points.size()) * sizeof(double), 0,
                   "The table of distances of centres and points", "Ask for fewer clusters.");
    row_.resize(seeds.size());
    limit_.resize(seeds.size());
    for (const Index seed : seeds) found_.centres.push_back(points[seed]);
    const auto nearest = workers.field_at_points(found_.centres, unreachable);
    for (const SurfacePoint& point : points) {
      if (const double distance = nearest(point); distance < unreachable) reach_ = std::max(reach_, distance);
    }
    parallel_for(seeds.size(), workers.threads(), workers.progress().part(0.1, 0.2), "Clusters",
                 [&](std::size_t i, int worker) { set_row(i, row_of(found_.centres[i], worker)); });
  }

  Clusters run(Index rounds, const Progress& progress) {
    divide();
    for (Index round = 0; round < rounds; ++round) {
      const double done = covered_after(100 * round);
      if (!move_centres(progress.part(done, covered_after(100 * (round + 1))))) break;
      divide();
    }
    progress.report(1.0, "Clusters");
    return std::move(found_);
  }

 private:
  /// A centre with a lower sum than the one before is at most twice as far from that one as the cluster's
  /// farthest point is. So no point of the cluster is farther from the new centre than this.
  double limit_of_row() const { return 3.0 * bounded_field_slack * reach_; }
  std::vector<double> row_of(const SurfacePoint& centre, int worker) {
    return workers_.few_distances(centre, points_, limit_of_row(), worker);
  }
  void set_row(std::size_t cluster, std::vector<double> row) {
    row_[cluster] = std::move(row);
    limit_[cluster] = limit_of_row();
  }

  double energy_of(std::size_t cluster, const std::vector<double>& row) const {
    double sum = 0.0;
    for (const Index j : members_[cluster]) sum += weights_[j] * powered(row[j], power_);
    return sum;
  }

  /// Each point goes to the nearest centre.
  void divide() {
    do {
      label();
    } while (lengthen_rows());
    double energy = 0.0;
    for (std::size_t i = 0; i < row_.size(); ++i) energy += energy_of(i, row_[i]);
    found_.energy.push_back(energy);
  }

  /// Labels points by the rows, as far as these reach.
  void label() {
    members_.assign(row_.size(), {});
    reach_ = 0.0;
    found_.label.assign(points_.size(), no_index);
    for (std::size_t j = 0; j < points_.size(); ++j) {
      double least = unreachable;
      for (std::size_t i = 0; i < row_.size(); ++i) {
        if (!(row_[i][j] < least)) continue;
        least = row_[i][j];
        found_.label[j] = static_cast<Index>(i);
      }
      if (found_.label[j] == no_index && !(weights_[j] > 0.0)) continue;  // on a component without a centre
      reach_ = std::max(reach_, least);
      if (weights_[j] > 0.0 && least < unreachable)
        members_[found_.label[j]].push_back(static_cast<Index>(j));
    }
  }

  /// \return whether any row ended before the farthest point of a cluster, so that labels may be wrong.
  bool lengthen_rows() {
    bool is_longer = false;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      if (limit_[i] >= reach_) continue;
      set_row(i, row_of(found_.centres[i], 0));
      is_longer = true;
    }
    return is_longer;
  }

  /// \return whether any moved.
  bool move_centres(const Progress& progress) {
    std::vector<char> moved(row_.size(), 0);
    if (power_ == Power::one) {
      for (std::size_t i = 0; i < row_.size(); ++i) {
        const auto share = [&](std::size_t k) {
          return static_cast<double>(k) / static_cast<double>(row_.size());
        };
        moved[i] = static_cast<char>(move_to(i, medoid_of(i, progress.part(share(i), share(i + 1))), 0));
      }
    } else {
      parallel_for(
          row_.size(), workers_.threads(), progress, "Means of clusters",
          [&](std::size_t i, int worker) { moved[i] = static_cast<char>(move_to(i, mean_of(i), worker)); });
    }
    return std::ranges::find(moved, 1) != moved.end();
  }

  bool move_to(std::size_t i, const SurfacePoint& centre, int worker) {
    if (centre == found_.centres[i]) return false;
    auto row = row_of(centre, worker);
    if (!(energy_of(i, row) < energy_of(i, row_[i]))) return false;
    found_.centres[i] = centre;
    set_row(i, std::move(row));
    return true;
  }

  std::pair<PointList, std::vector<double>> members(std::size_t cluster) const {
    std::vector<SurfacePoint> points;
    std::vector<double> weights;
    for (const Index j : members_[cluster]) {
      points.push_back(points_[j]);
      weights.push_back(weights_[j]);
    }
    return {points, weights};
  }

  SurfacePoint medoid_of(std::size_t cluster, const Progress& progress) {
    if (members_[cluster].empty()) return found_.centres[cluster];
    const auto [points, weights] = members(cluster);
    std::vector<double> row;
    for (const Index j : members_[cluster]) row.push_back(row_[cluster][j]);
    const auto energy = least_energies(workers_, points, weights, power_, row, progress);
    return points[std::ranges::min_element(energy) - energy.begin()];
  }

  SurfacePoint mean_of(std::size_t cluster) const {
    if (members_[cluster].empty()) return found_.centres[cluster];
    const auto [points, weights] = members(cluster);
    double reach = 0.0;
    for (const Index j : members_[cluster]) reach = std::max(reach, row_[cluster][j]);
    return descend(surface_, found_.centres[cluster], points, weights, power_, bounded_field_slack * reach, 1)
        .point;
  }

  Surface& surface_;
  Workers& workers_;
  const PointList& points_;
  const std::span<const double> weights_;
  const Power power_;
  /// By cluster: distances of the points from its centre; `unreachable` for points far beyond its cluster.
  std::vector<std::vector<double>> row_{};
  std::vector<double> limit_{};  ///< by cluster: beyond it, its row is `unreachable`
  double reach_ = 0.0;           ///< the greatest distance of a point from its nearest centre
  std::vector<std::vector<Index>> members_{};
  Clusters found_{};
};

}  // namespace

Clusters clusters_of(Surface& surface, Index count, const std::optional<PointList>& given,
                     std::span<const double> given_weights, Power power, Index rounds, std::uint64_t seed,
                     const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  if (rounds < 0) throw InvalidInput("The number of rounds is negative; give 0 or more.");
  require_both_ways_alike(mesh, "Clusters");
  if (given) {
    const PointList points = points_on(mesh, *given, "Point");
    const auto weights = checked_weights(given_weights, points.size());
    require_enough(mesh, count, points, weights);
    Workers workers(surface, options, (usual_rounds + 2.0) * count);
    const auto first = seeds(count, weights, power, seed, workers.progress().part(0.0, 0.1),
                             [&](Index next, double farthest, std::vector<double>& nearest) {
                               const auto row = workers.distances(points[next], points, farthest, 0);
                               for (std::size_t i = 0; i < row.size(); ++i)
                                 nearest[i] = std::min(nearest[i], row[i]);
                             });
    return PointClusters(surface, workers, points, weights, power, first)
        .run(rounds, workers.progress().part(0.2, 1.0));
  }
  std::vector<double> weights =
      given_weights.empty()
          ? vertex_areas(mesh)
          : checked_weights(given_weights, static_cast<std::size_t>(mesh.given_vertex_count()));
  weights.resize(mesh.vertex_count(), 0.0);
  std::vector<Index> vertices(weights.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  for (const Index v : vertices) {
    if (mesh.fan(v) == Mesh::Fan::isolated) weights[v] = 0.0;
  }
  require_enough(mesh, count, vertices, weights);
  const auto first = seeds(
      count, weights, power, seed, options.progress.part(0.0, 0.1),
      [&](Index next, double, std::vector<double>& nearest) { lower_along_edges(mesh, next, nearest); });
  TaskOptions moving = options;
  moving.progress = options.progress.part(0.1, 1.0);
  auto found = relax_points(surface, first, rounds, moving, weights, power);
  return {std::move(found.points), InputMap(mesh).of_vertices(std::move(found.region)),
          std::move(found.energy)};
}

}  // namespace vorogeo
