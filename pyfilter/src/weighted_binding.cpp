// The functions of _core for metrics that jump at edges, and for paths without an index.
#include "weighted_binding.h"

#include <map>

#include "arrays.h"
#include "mesh/edge_points.h"
#include "mesh/metric.h"
#include "mesh_points.h"
#include "query/mesh_path.h"
#include "progress_bridge.h"
#include "support/progress.h"
#include "exact/paths_from_point.h"

namespace vorogeo::python {

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

}  // namespace vorogeo::python
