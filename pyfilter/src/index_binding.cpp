// The index, its queries and its paths.
#include "index_binding.h"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

#include "arrays.h"
#include "exact/local_solver.h"
#include "exact/paths_from_point.h"
#include "index/geodesic_index.h"
#include "mesh/edge_points.h"
#include "mesh/given_points.h"
#include "mesh/metric.h"
#include "mesh_binding.h"
#include "progress_bridge.h"
#include "query/mesh_path.h"
#include "query/path_query.h"
#include "support/parallel.h"
#include "support/progress.h"
#include "tasks/distance_matrix.h"

namespace vorogeo::python {

// ---- The class _core.Index: a built index with its queries, without argument checks

namespace {

/// What a Python index object holds.
class IndexHandle {
 public:
  IndexHandle(std::shared_ptr<const GeodesicIndex> index, std::size_t input_faces, int threads)
      : pool_(std::make_shared<QueryPool>(std::move(index), threads)), input_faces_(input_faces) {}

  const GeodesicIndex& index() const { return pool_->index(); }
  HeldIndex held() const { return {pool_->shared_index(), pool_, pool_->threads(), input_faces_}; }

  double distance(Index source, Index target) {
    nb::gil_scoped_release release;
    return pool_->lend([&](GeodesicQuery& query) { return query.distance(source, target); });
  }

  DoubleArray distances(const IdArray& sources, const IdArray& targets) {
    const auto from = ids_of(sources);
    const auto to = ids_of(targets);
    std::vector<double> values(from.size());
    auto fill = [&](std::size_t begin, std::size_t end) {
      pool_->lend([&](GeodesicQuery& query) {
        for (std::size_t i = begin; i < end; ++i) values[i] = query.distance(from[i], to[i]);
        return true;
      });
    };
    constexpr std::size_t pairs_at_once = 256;
    if (values.size() <= pairs_at_once) {
      nb::gil_scoped_release release;
      fill(0, values.size());
    } else {
      ProgressBridge bridge{nb::handle(Py_None)};
      bridge.run([&](const Progress& progress) {
        const std::size_t count = (values.size() + pairs_at_once - 1) / pairs_at_once;
        parallel_for(count, pool_->threads(), progress, "Distances", [&](std::size_t item, int) {
          fill(item * pairs_at_once, std::min(values.size(), (item + 1) * pairs_at_once));
        });
      });
    }
    return to_numpy(std::move(values));
  }

  DoubleArray distance_field(const IdArray& sources, double max_distance) {
    std::vector<double> values;
    {
      nb::gil_scoped_release release;
      values = pool_->lend(
          [&](GeodesicQuery& query) { return query.distance_field(ids_of(sources), max_distance); });
    }
    return of_given_vertices(*index().mesh(), std::move(values));
  }

  /// Patches by input face, of one in parts that at its centre; no_index for a face that the mesh leaves out.
  IndexArray face_patches(int layer) const {
    const std::span<const Index> patches = index().face_patches(layer);
    std::vector<Index> values(input_faces_, no_index);
    for (Index f : central_parts(*index().mesh())) values[index().mesh()->input_face(f)] = patches[f];
    return to_numpy(std::move(values));
  }

  void save(const std::filesystem::path& file) const {
    nb::gil_scoped_release release;
    index().save(file);
  }

  /// How many bridges join borders.
  Index bridge_count() const { return index().mesh()->face_count() - index().mesh()->first_bridge(); }

  nb::dict statistics() const {
    const IndexStatistics& s = index().statistics();
    nb::dict d;
    const Mesh& mesh = *index().mesh();
    Index faces = 0;
    for (Index f = 0; f < mesh.first_bridge(); ++f) {
      faces += f == 0 || mesh.input_face(f) != mesh.input_face(f - 1);
    }
    d["vertices"] = s.vertices;
    d["faces"] = faces;
    d["bridges"] = bridge_count();
    d["components"] = s.components;
    d["first_layer_patches"] = s.first_layer_patches;
    d["second_layer_patches"] = s.second_layer_patches;
    d["first_layer_border_vertices"] = s.first_layer_border_vertices;
    d["second_layer_border_vertices"] = s.second_layer_border_vertices;
    d["form"] = to_string(s.form);
    d["arcs_before_pruning"] = s.arcs_before_pruning;
    d["arcs"] = s.arcs;
    d["bytes"] = s.bytes;
    d["mapped_bytes"] = s.mapped_bytes;
    d["seconds"] = s.seconds;
    d["expected_fields"] = s.expected_fields;
    d["delta"] = s.delta;
    d["seed"] = s.seed;
    return d;
  }

 private:
  std::shared_ptr<QueryPool> pool_;
  std::size_t input_faces_;
};

/// The Python object owns what build and load return.
IndexHandle* build(const VertexArray& vertices, const FaceArray& faces, const SideArray& sides,
                   Index first_layer_patches, Index second_layer_patches, double delta, int threads,
                   std::uint64_t seed, std::int64_t memory_budget, double gap, bool folds,
                   const std::optional<std::filesystem::path>& file, nb::object progress) {
  IndexOptions options;
  options.first_layer_patches = first_layer_patches;
  options.second_layer_patches = second_layer_patches;
  options.delta = delta;
  options.threads = threads;
  options.seed = seed;
  options.memory_budget = memory_budget;
  ProgressBridge bridge(progress);
  auto index = bridge.run([&](const Progress& report) {
    std::shared_ptr<const Mesh> mesh;
    {
      const Watch watch(report.part(0.0, 0.01), "Reading the mesh");
      mesh = mesh_of(vertices, faces, sides, {gap, folds});
    }
    const Progress rest = report.part(0.01, 1.0);
    return file ? GeodesicIndex::build_in_file(*file, std::move(mesh), options, rest)
                : GeodesicIndex::build(std::move(mesh), options, rest);
  });
  return new IndexHandle(std::move(index), faces.shape(0), threads);
}

IndexHandle* load(const std::filesystem::path& file, const VertexArray& vertices, const FaceArray& faces,
                  const SideArray& sides, int threads, double gap, bool folds, bool mapped) {
  nb::gil_scoped_release release;
  auto index = GeodesicIndex::load(file, mesh_of(vertices, faces, sides, {gap, folds}),
                                   mapped ? TableStorage::mapped : TableStorage::copied);
  return new IndexHandle(std::move(index), faces.shape(0), threads);
}

}  // namespace

HeldIndex held_index(nb::handle object) { return nb::cast<const IndexHandle&>(object).held(); }

nb::object index_object(std::shared_ptr<const GeodesicIndex> index, std::size_t input_faces, int threads) {
  return nb::cast(new IndexHandle(std::move(index), input_faces, threads), nb::rv_policy::take_ownership);
}

void bind_index(nb::module_& module) {
  nb::class_<IndexHandle>(module, "Index")
      .def_static("build", &build, nb::arg("vertices"), nb::arg("faces"), nb::arg("sides").none(),
                  nb::arg("first_layer_patches"), nb::arg("second_layer_patches"), nb::arg("delta"),
                  nb::arg("threads"), nb::arg("seed"), nb::arg("memory_budget"), nb::arg("gap"),
                  nb::arg("folds"), nb::arg("file").none(), nb::arg("progress").none())
      .def_static("load", &load, nb::arg("file"), nb::arg("vertices"), nb::arg("faces"),
                  nb::arg("sides").none(), nb::arg("threads"), nb::arg("gap"), nb::arg("folds"),
                  nb::arg("mapped"))
      .def("distance", &IndexHandle::distance, nb::arg("source"), nb::arg("target"))
      .def("distances", &IndexHandle::distances, nb::arg("sources"), nb::arg("targets"))
      .def("distance_field", &IndexHandle::distance_field, nb::arg("sources"), nb::arg("max_distance"))
      .def("face_patches", &IndexHandle::face_patches, nb::arg("layer"))
      .def("save", &IndexHandle::save, nb::arg("file"))
      .def("statistics", &IndexHandle::statistics);
}

// ---- The functions of _core for metrics that jump at edges, and for paths without an index

namespace {

DoubleArray sides_by_cost(const VertexArray& vertices, const FaceArray& faces, const ValueArray& cost) {
  return flattened(
      sides_by_face_cost(points_of(vertices), triangles_of(faces), std::span(cost.data(), cost.shape(0))));
}

DoubleArray sides_by_tensor(const VertexArray& vertices, const FaceArray& faces, const ValueArray& values) {
  std::vector<Tensor> tensors(values.shape(0) / 9);
  const double* value = values.data();
  for (Tensor& tensor : tensors) {
    for (double& entry : tensor) entry = *value++;
  }
  return flattened(sides_by_face_tensor(points_of(vertices), triangles_of(faces), tensors));
}

Index points_for(const VertexArray& vertices, const FaceArray& faces, const VertexArray& sides) {
  return edge_points_for(points_of(vertices), triangles_of(faces), points_of(sides));
}

/// The number of targets of one source from which one propagation over the mesh, which serves them all, is
/// usually faster than a corridor for each.
constexpr std::size_t targets_worth_propagation = 100;

/// Calls solve(source, pairs) for each different source, with the numbers of its pairs.
template <class Solve>
void for_each_source(const PointList& sources, Solve&& solve) {
  std::map<SurfacePoint, std::vector<std::size_t>> pairs;
  for (std::size_t i = 0; i < sources.size(); ++i) pairs[sources[i]].push_back(i);
  for (const auto& [source, ones] : pairs) solve(source, ones);
}

std::vector<ExactPath> exact_paths(const std::shared_ptr<const Mesh>& mesh, const PointList& sources,
                                   const PointList& targets, const Progress& progress) {
  std::vector<ExactPath> found(sources.size());
  const auto geometry = std::make_shared<const LocalGeometry>(mesh);
  MeshPathQuery corridors(geometry);
  std::unique_ptr<PathsFromPoint> propagation;
  Watch watch(progress, "Shortest paths");
  std::size_t done = 0;
  for_each_source(sources, [&](const SurfacePoint& source, const std::vector<std::size_t>& pairs) {
    // Where the metric jumps, there are no bounds that make a corridor.
    const bool together = mesh->metric_jumps() || pairs.size() >= targets_worth_propagation;
    if (together && !propagation) propagation = std::make_unique<PathsFromPoint>(geometry);
    if (together) propagation->reset(source);
    for (const std::size_t i : pairs) {
      found[i] = together ? corridors.exact_path(*propagation, targets[i])
                          : corridors.exact_path(source, targets[i]);
      watch.reach(static_cast<double>(++done) / static_cast<double>(sources.size()));
    }
  });
  return found;
}

nb::tuple paths_without_index(const VertexArray& vertices, const FaceArray& faces, const SideArray& sides,
                              const PointArrays& source, const PointArrays& target, double gap, bool folds,
                              nb::object progress) {
  const auto mesh = mesh_of(vertices, faces, sides, {gap, folds});
  const PointList sources = points_on(*mesh, points_from(*mesh, source), "Source");
  const PointList targets = points_on(*mesh, points_from(*mesh, target), "Target");
  ProgressBridge bridge(progress);
  const auto found =
      bridge.run([&](const Progress& report) { return exact_paths(mesh, sources, targets, report); });
  return MeshPoints(mesh).path_arrays(found);
}

}  // namespace

void bind_weighted(nb::module_& module) {
  const nb::arg vertices("vertices"), faces("faces");
  module.def("sides_by_face_cost", &sides_by_cost, vertices, faces, nb::arg("cost"));
  module.def("sides_by_face_tensor", &sides_by_tensor, vertices, faces, nb::arg("tensors"));
  module.def("edge_points_for", &points_for, vertices, faces, nb::arg("sides"));
  module.def("paths_without_index", &paths_without_index, vertices, faces, nb::arg("sides").none(),
             nb::arg("sources"), nb::arg("targets"), nb::arg("gap"), nb::arg("folds"),
             nb::arg("progress").none());
}

// ---- The class _core.Paths: points anywhere on the surface of an index's mesh, their paths and fields

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
