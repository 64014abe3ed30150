// The functions of _core for metrics that jump at edges, and for paths without an index.
#include "weighted_binding.h"

#include <algorithm>
#include <map>

#include "arrays.h"
#include "exact/exact_solver.h"
#include "mesh/metric.h"
#include "path_arrays.h"
#include "progress_bridge.h"
#include "support/checkpoint.h"
#include "weighted/weighted_solver.h"

namespace vorogeo::python {

namespace {

using ValueArray = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

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

/// For each pair the path that `solve` (from a source) and `find` (to a target) give; pairs with one source
/// after the other.
template <class Solve, class Find>
std::vector<SurfacePath> paths_of_pairs(const PointList& sources, const PointList& targets, Solve&& solve,
                                        Find&& find) {
  std::map<SurfacePoint, std::vector<std::size_t>> pairs;
  for (std::size_t i = 0; i < sources.size(); ++i) pairs[sources[i]].push_back(i);
  std::vector<SurfacePath> found(sources.size());
  for (const auto& [source, ones] : pairs) {
    solve(source);
    for (const std::size_t i : ones) {
      found[i] = find(targets[i]);
      if (found[i].points.empty()) found[i].length = unreachable;
      std::ranges::reverse(found[i].points);
    }
  }
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
    if (points > 0) {
      WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, points_of(*sides), points));
      return paths_of_pairs(
          sources, targets,
          [&](const SurfacePoint& from) { solver.run(std::span(&from, 1), unreachable, report); },
          [&](const SurfacePoint& to) { return solver.path_to_source(to); });
    }
    ExactSolver solver(mesh);
    return paths_of_pairs(
        sources, targets,
        [&](const SurfacePoint& from) {
          const ExactSource one{from};
          ExactLimits limits;
          limits.progress = &report;
          solver.run(std::span(&one, 1), limits);
        },
        [&](const SurfacePoint& to) { return solver.path_to_source(to); });
  });
  PathArrays arrays(*mesh);
  for (const SurfacePath& path : found) arrays.add(path, points == 0 && !path.points.empty());
  return arrays.take();
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
