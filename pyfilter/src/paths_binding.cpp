// The class _core.Paths: points anywhere on the surface of an index's mesh, their paths and fields.
#include "paths_binding.h"

#include <algorithm>
#include <mutex>

#include "arrays.h"
#include "index_binding.h"
#include "mesh_points.h"
#include "query/path_query.h"
#include "point_arrays.h"
#include "progress_bridge.h"
#include "support/parallel.h"
#include "tasks/distance_matrix.h"
#include "exact/local_solver.h"

namespace vorogeo::python {

namespace {

/// Queries on one index, each lent to one caller at a time; created when first needed.
class Paths {
 public:
  explicit Paths(nb::handle index) : held_(held_index(index)), points_(held_.index->mesh()) {}

  nb::tuple snap(const VertexArray& points) { return points_.snap(points); }
  nb::tuple along_edges(const EdgeArray& ends, double spacing) const {
    return points_.along_edges(ends, spacing);
  }

  /// Paths of pairs: lengths, certified, where the points of each path begin, positions, vertices, faces,
  /// weights, and which points begin a step over a gap.
  nb::tuple paths(const PointArrays& source, const PointArrays& target, bool exact, bool certify,
                  nb::object progress) {
    const PointList sources = points_on(mesh(), points_from(mesh(), source), "Source");
    const PointList targets = points_on(mesh(), points_from(mesh(), target), "Target");
    std::vector<ExactPath> found(sources.size());
    ProgressBridge bridge(progress);
    bridge.run([&](const Progress& report) {
      const bool prepares = exact && certify && found.size() >= pairs_worth_landmarks && !has_landmarks();
      if (prepares) make_landmarks(ExactLandmarks::max_count, report.part(0.0, 0.5));
      constexpr std::size_t at_once = 16;
      const std::size_t blocks = (found.size() + at_once - 1) / at_once;
      const Progress left = report.part(prepares ? 0.5 : 0.0, 1.0);
      parallel_for(blocks, held_.threads, left, "Paths", [&](std::size_t block, int) {
        std::unique_ptr<PathQuery> query = take_query();
        for (std::size_t i = block * at_once; i < std::min(found.size(), (block + 1) * at_once); ++i) {
          found[i] = exact ? query->exact_path(sources[i], targets[i], certify)
                           : ExactPath{query->path(sources[i], targets[i]), false};
        }
        const std::lock_guard lock(mutex_);
        queries_.push_back(std::move(query));
      });
      return true;
    });
    return points_.path_arrays(found);
  }

  /// Narrows the corridors of certified paths from this call on. \return the memory that the landmarks take,
  /// in bytes.
  std::size_t use_landmarks(int count, nb::object progress) {
    std::size_t bytes = 0;
    ProgressBridge bridge(progress);
    bridge.run([&](const Progress& report) {
      bytes = make_landmarks(count, report);
      return true;
    });
    return bytes;
  }

  /// Distances of all vertices from the nearest source, and which it is; from the index or exact.
  nb::tuple field(const PointArrays& source, const ValueArray& offsets, double max_distance, bool exact) {
    const PointList points = points_on(mesh(), points_from(mesh(), source), "Source");
    LabelledField result;
    std::vector<ExactSource> sources;
    {
      nb::gil_scoped_release release;
      for (std::size_t i = 0; i < points.size(); ++i) sources.push_back({points[i], offsets.data()[i]});
      if (!exact) {
        result = held_.pool->lend(
            [&](GeodesicQuery& query) { return query.labelled_field(sources, max_distance); });
      }
    }
    if (exact) result = exact_field(sources, max_distance);
    return nb::make_tuple(of_given_vertices(mesh(), std::move(result.distance)),
                          of_given_vertices(mesh(), std::move(result.source)));
  }

 private:
  /// Number of pairs in one call from which landmarks usually save more time than they cost (docs/paths.md).
  static constexpr std::size_t pairs_worth_landmarks = 1000;

  /// Ctrl-C stops it.
  LabelledField exact_field(const std::vector<ExactSource>& sources, double max_distance) const {
    ProgressBridge bridge{nb::handle(Py_None)};
    return bridge.run([&](const Progress& progress) {
      LocalSolver solver(held_.index->mesh());
      ExactLimits limits;
      limits.max_distance = max_distance;
      limits.progress = &progress;
      limits.distances_only = true;
      limits.threads = threads_for_field(solver.mesh(), held_.threads);
      solver.run(sources, limits);
      return labelled_field_of(solver, max_distance);
    });
  }

  bool has_landmarks() {
    const std::lock_guard lock(mutex_);
    return landmarks_ != nullptr;
  }

  /// \return the memory they take, in bytes.
  std::size_t make_landmarks(int count, const Progress& report) {
    auto made = landmarks_of(held_.index, count, held_.threads, report);
    const std::lock_guard lock(mutex_);
    landmarks_ = std::move(made);
    return landmarks_->memory_bytes();
  }

  const Mesh& mesh() const { return *held_.index->mesh(); }

  std::unique_ptr<PathQuery> take_query() {
    std::unique_ptr<PathQuery> query;
    std::shared_ptr<const ExactLandmarks> landmarks;
    {
      const std::lock_guard lock(mutex_);
      landmarks = landmarks_;
      if (!queries_.empty()) {
        query = std::move(queries_.back());
        queries_.pop_back();
      }
    }
    if (!query) query = std::make_unique<PathQuery>(held_.index);
    query->use_landmarks(std::move(landmarks));
    return query;
  }

  HeldIndex held_;
  MeshPoints points_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<PathQuery>> queries_;
  std::shared_ptr<const ExactLandmarks> landmarks_;
};

}  // namespace

void bind_paths(nb::module_& module) {
  nb::class_<Paths>(module, "Paths")
      .def(nb::init<nb::handle>(), nb::arg("index"))
      .def("snap", &Paths::snap, nb::arg("points"))
      .def("paths", &Paths::paths, nb::arg("sources"), nb::arg("targets"), nb::arg("exact"),
           nb::arg("certify"), nb::arg("progress").none())
      .def("use_landmarks", &Paths::use_landmarks, nb::arg("count"), nb::arg("progress").none())
      .def("field", &Paths::field, nb::arg("sources"), nb::arg("offsets"), nb::arg("max_distance"),
           nb::arg("exact"))
      .def("along_edges", &Paths::along_edges, nb::arg("ends"), nb::arg("spacing"));
}

void bind_points(nb::module_& module) {
  nb::class_<PointArrays>(module, "Points")
      .def(
          "__init__",
          [](PointArrays* self, IdArray vertex, IdArray face, VertexArray weights) {
            new (self) PointArrays{std::move(vertex), std::move(face), std::move(weights)};
          },
          nb::arg("vertex"), nb::arg("face"), nb::arg("weights"));
}

}  // namespace vorogeo::python
