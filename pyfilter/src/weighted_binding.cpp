// The functions of _core for metrics that jump at edges, and for paths without an index.
#include "weighted_binding.h"

#include <algorithm>
#include <map>

#include "arrays.h"
#include "exact/exact_geometry.h"
#include "exact/paths_from_point.h"
#include "mesh/metric.h"
#include "mesh_points.h"
#include "path/mesh_path.h"
#include "progress_bridge.h"
#include "support/checkpoint.h"
#include "weighted/weighted_solver.h"

namespace vorogeo::python {

namespace {

DoubleArray flattened(const SideLengths& rows) {
  std::vector<double> values;
  for (const auto& row : rows) values.insert(values.end(), row.begin(), row.end());
  return to_numpy(std::move(values));
}

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

std::shared_ptr<const FaceNorms> norms_of(const VertexArray& vertices, const FaceArray& faces,
                                          const VertexArray& sides, Index points) {
  return std::make_shared<const FaceNorms>(mesh_of(vertices, faces, std::nullopt), points_of(sides), points);
}

DoubleArray weighted_field(const VertexArray& vertices, const FaceArray& faces, const VertexArray& sides,
                           Index points, const IdArray& sources, double max_distance) {
  ProgressBridge bridge{nb::none()};
  return to_numpy(bridge.run([&](const Progress& progress) {
    WeightedSolver solver(norms_of(vertices, faces, sides, points));
    std::vector<SurfacePoint> from;
    for (const Index v : ids_of(sources)) from.push_back(SurfacePoint::at_vertex(v));
    solver.run(from, max_distance, progress);
    std::vector<double> distances(vertices.shape(0));
    for (std::size_t v = 0; v < distances.size(); ++v) distances[v] = solver.distance(static_cast<Index>(v));
    return distances;
  }));
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
  const auto geometry = std::make_shared<const ExactGeometry>(mesh);
  MeshPathQuery corridors(geometry);
  std::unique_ptr<PathsFromPoint> propagation;
  Watch watch(progress, "Shortest paths");
  std::size_t done = 0;
  for_each_source(sources, [&](const SurfacePoint& source, const std::vector<std::size_t>& pairs) {
    const bool together = pairs.size() >= targets_worth_propagation;
    if (together && !propagation) propagation = std::make_unique<PathsFromPoint>(geometry);
    if (together) propagation->reset(source);
    for (const std::size_t i : pairs) {
      if (together) {
        found[i].path = propagation->path_to(targets[i]);
        found[i].certified = true;
      } else {
        found[i] = corridors.exact_path(source, targets[i]);
      }
      watch.reach(static_cast<double>(++done) / static_cast<double>(sources.size()));
    }
  });
  return found;
}

std::vector<ExactPath> weighted_paths(const std::shared_ptr<const FaceNorms>& norms, const PointList& sources,
                                      const PointList& targets, const Progress& progress) {
  std::vector<ExactPath> found(sources.size());
  WeightedSolver solver(norms);
  for_each_source(sources, [&](const SurfacePoint& source, const std::vector<std::size_t>& pairs) {
    solver.run(std::span(&source, 1), unreachable, progress);
    for (const std::size_t i : pairs) {
      SurfacePath& path = found[i].path;
      path = solver.path_to_source(targets[i]);
      if (path.points.empty()) path.length = unreachable;
      std::ranges::reverse(path.points);
    }
  });
  return found;
}

/// `points`: on each edge, for sides on which the faces of an edge disagree; 0: exact.
nb::tuple paths_without_index(const VertexArray& vertices, const FaceArray& faces, const SideArray& sides,
                              Index points, const PointArrays& source, const PointArrays& target, double gap,
                              bool folds, nb::object progress) {
  const auto mesh = mesh_of(vertices, faces, points > 0 ? std::nullopt : sides, {gap, folds});
  const PointList sources = points_on(*mesh, points_from(*mesh, source), "Source");
  const PointList targets = points_on(*mesh, points_from(*mesh, target), "Target");
  ProgressBridge bridge(progress);
  const auto found = bridge.run([&](const Progress& report) {
    if (points == 0) return exact_paths(mesh, sources, targets, report);
    const auto norms = std::make_shared<const FaceNorms>(mesh, points_of(*sides), points);
    return weighted_paths(norms, sources, targets, report);
  });
  return MeshPoints(mesh).path_arrays(found);
}

}  // namespace

void bind_weighted(nb::module_& module) {
  const nb::arg vertices("vertices"), faces("faces"), points("points");
  module.def("sides_by_face_cost", &sides_by_cost, vertices, faces, nb::arg("cost"));
  module.def("sides_by_face_tensor", &sides_by_tensor, vertices, faces, nb::arg("tensors"));
  module.def("weighted_field", &weighted_field, vertices, faces, nb::arg("sides"), points, nb::arg("sources"),
             nb::arg("max_distance"));
  module.def("paths_without_index", &paths_without_index, vertices, faces, nb::arg("sides").none(), points,
             nb::arg("sources"), nb::arg("targets"), nb::arg("gap"), nb::arg("folds"),
             nb::arg("progress").none());
}

}  // namespace vorogeo::python
