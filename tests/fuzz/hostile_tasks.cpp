// Tasks made of many exact fields: matrices, pairs within a radius (what gdist's interface is made of), the
// nearest of a set, disks, samplings and extents agree with the fields themselves.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "fuzz/hostile_case.h"
#include "query/surface.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/neighbors.h"
#include "tasks/spread_points.h"

namespace vorogeo::test {

namespace {

/// Vertices that are used besides the two sources.
constexpr int more_points = 6;
constexpr Index samples_asked = 6;
constexpr Index fields_of_extent = 8;
/// Samples whose distances to the others are checked.
constexpr std::size_t fields_of_samples = 10;

class TaskCheck {
 public:
  explicit TaskCheck(HostileCase& hostile)
      : hostile_(hostile),
        random_(hostile.seed + (30ULL << 40)),
        surface_(hostile.mesh, {.threads = random_.one_in(2) ? 1 : 3}),
        points_{hostile.sources[0], hostile.sources[1]} {
    const Mesh& mesh = *hostile.mesh;
    for (int i = 0; i < more_points; ++i) {
      points_.push_back(mesh.face_vertices(static_cast<Index>(random_.below(mesh.face_count())))[0]);
    }
    for (const double distance : hostile.exact[0]) {
      if (distance < unreachable) farthest_ = std::max(farthest_, distance);
    }
    radius_ = farthest_ * random_.uniform(0.1, 0.9);
  }

  void check_matrix() {
    hostile_.ask("matrix of " + std::to_string(points_.size()) + " vertices");
    const std::size_t count = points_.size();
    std::vector<double> matrix(count * count);
    distance_matrix<double>(surface_, PointList(points_), MatrixMethod::fields, matrix, by_exact_);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < count; ++k) {
        const double entry = matrix[i * count + k];
        if (entry != matrix[k * count + i]) hostile_.fail("a matrix is not symmetric", exactly(entry));
        if (i < 2)
          hostile_.require_same("a matrix has another distance", points_[k], hostile_.exact[i][points_[k]],
                                entry);
      }
    }
  }

  void check_pairs_within() {
    hostile_.ask("pairs within " + exactly(radius_));
    const SparseDistances pairs = pairs_within(surface_, PointList(points_), radius_, 0, by_exact_);
    for (int i = 0; i < 2; ++i) {
      std::vector<double> row(points_.size(), unreachable);
      for (std::int64_t at = pairs.row_begin[i]; at < pairs.row_begin[i + 1]; ++at) {
        row[pairs.column[at]] = pairs.distance[at];
      }
      for (std::size_t k = 0; k < points_.size(); ++k) {
        if (static_cast<int>(k) == i) continue;
        const double exact = hostile_.exact[i][points_[k]];
        if (std::abs(exact - radius_) <= hostile_.slack(exact)) continue;
        hostile_.require_same("pairs within a radius are others", points_[k],
                              exact < radius_ ? exact : unreachable, row[k]);
      }
    }
  }

  void check_nearest() {
    hostile_.ask("the nearer of both sources");
    const NearestOfSet nearest =
        nearest_of_set(surface_, PointList(hostile_.sources), PointList(points_), 2, by_exact_);
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const double first = hostile_.exact[0][points_[k]];
      const double second = hostile_.exact[1][points_[k]];
      const std::string kind = "the nearest of a set are others";
      hostile_.require_same(kind, points_[k], std::min(first, second), nearest.distance[2 * k]);
      hostile_.require_same(kind, points_[k], std::max(first, second), nearest.distance[2 * k + 1]);
    }
  }

  void check_disk() {
    hostile_.ask("disk of radius " + exactly(radius_));
    const Disk disk = geodesic_disk(surface_, PointList(std::array{hostile_.sources[0]}), radius_, by_exact_);
    std::vector<double> inside(hostile_.mesh->vertex_count(), unreachable);
    for (std::size_t i = 0; i < disk.vertices.size(); ++i) inside[disk.vertices[i]] = disk.distance[i];
    for (Index v = 0; v < hostile_.mesh->vertex_count(); ++v) {
      const double exact = hostile_.exact[0][v];
      if (std::abs(exact - radius_) <= hostile_.slack(exact)) continue;
      hostile_.require_same("a disk has another vertex", v, exact < radius_ ? exact : unreachable, inside[v]);
    }
  }

  void check_farthest() {
    hostile_.ask("samples far from each other");
    const FarthestSamples samples = sample_farthest(surface_, {.count = samples_asked},
                                                    PointList(std::array{hostile_.sources[0]}), 0, by_exact_);
    const auto field = exact_distance_field(hostile_.mesh, PointList(samples.points).vertices());
    hostile_.require_same(
        "the distance from samples is another", [&](Index v) { return field[v]; },
        [&](Index v) { return samples.distance[v]; });
    for (std::size_t i = 2; i < samples.radius.size(); ++i) {
      if (samples.radius[i] > samples.radius[i - 1] + hostile_.slack(samples.radius[i - 1]))
        hostile_.fail("a later sample is farther away", exactly(samples.radius[i]));
    }
  }

  void check_poisson_disk() {
    if (!(radius_ > 0.0)) return;
    hostile_.ask("samples " + exactly(radius_) + " apart");
    const std::vector<Index> samples = sample_poisson_disk(surface_, radius_, hostile_.seed, by_exact_);
    for (std::size_t i = 0; i < std::min(samples.size(), fields_of_samples); ++i) {
      const auto field = exact_distance_field(hostile_.mesh, std::array{samples[i]});
      for (const Index other : samples) {
        if (other != samples[i] && field[other] < radius_ - hostile_.slack(radius_))
          hostile_.fail("samples are too close", vertex(other) + exactly(field[other]));
      }
    }
    const auto field = exact_distance_field(hostile_.mesh, samples);
    for (Index v = 0; v < hostile_.mesh->vertex_count(); ++v) {
      if (hostile_.exact[0][v] < unreachable && field[v] > radius_ + hostile_.slack(radius_))
        hostile_.fail("there is room for another sample", vertex(v) + exactly(field[v]));
    }
  }

  void check_extent() {
    hostile_.ask("extent of the component of vertex " + std::to_string(hostile_.sources[0]));
    const Extent extent = extent_of_component(surface_, hostile_.sources[0], fields_of_extent, by_exact_);
    const auto field = exact_distance_field(hostile_.mesh, std::array{extent.ends[0]});
    hostile_.require_same("the ends of a diameter are another distance apart", extent.ends[1],
                          field[extent.ends[1]], extent.diameter.lower);
    const auto at_most = [&](double less, double more) { return less <= more + hostile_.slack(more); };
    if (!at_most(farthest_, extent.diameter.lower) ||
        !at_most(extent.diameter.lower, extent.diameter.upper) ||
        !at_most(extent.radius.lower, extent.radius.upper) || !at_most(extent.radius.lower, farthest_))
      hostile_.fail("an extent has wrong bounds", exactly(farthest_) + ", diameter " +
                                                      exactly(extent.diameter.lower) + " to " +
                                                      exactly(extent.diameter.upper));
  }

 private:
  static std::string vertex(Index v) { return "vertex " + std::to_string(v) + ": "; }

  HostileCase& hostile_;
  HostileRandom random_;
  Surface surface_;
  std::vector<Index> points_;  ///< the sources first
  double farthest_ = 0.0;      ///< distance from the first source
  double radius_ = 0.0;
  const TaskOptions by_exact_{.by = Answer::exact};
};

}  // namespace

void check_tasks(HostileCase& hostile) {
  if (hostile.exact[1].empty()) return;
  TaskCheck check(hostile);
  hostile.attempt([&] { check.check_matrix(); });
  hostile.attempt([&] { check.check_pairs_within(); });
  hostile.attempt([&] { check.check_nearest(); });
  hostile.attempt([&] { check.check_disk(); });
  hostile.attempt([&] { check.check_farthest(); });
  hostile.attempt([&] { check.check_poisson_disk(); });
  hostile.attempt([&] { check.check_extent(); });
}

}  // namespace vorogeo::test
