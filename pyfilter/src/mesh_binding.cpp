// Meshes, points on them, metrics and checks.
#include "mesh_binding.h"

#include <nanobind/stl/string.h>

#include <string>

#include "arrays.h"
#include "index/build_estimate.h"
#include "mesh/edge_points.h"
#include "mesh/given_points.h"
#include "mesh/mesh_check.h"
#include "mesh/metric.h"
#include "progress_bridge.h"
#include "tasks/curve_sources.h"

namespace vorogeo::python {

// ---- Points of a mesh in numpy arrays

nb::tuple MeshPoints::snap(const VertexArray& points) {
  PointRows rows;
  std::vector<double> distances(points.shape(0));
  {
    nb::gil_scoped_release release;
    const SurfaceLocator& on_surface = locator();
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double* p = points.data() + 3 * i;
      const SnappedPoint found = on_surface.nearest({p[0], p[1], p[2]});
      distances[i] = found.distance;
      rows.add(mesh(), found.point);
    }
  }
  return nb::make_tuple(to_numpy(std::move(rows.face)), to_numpy(std::move(rows.weights)),
                        to_numpy(std::move(distances)));
}

nb::tuple MeshPoints::along_edges(const EdgeArray& ends, double spacing) const {
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t i = 0; i < ends.shape(0); ++i) pairs.push_back({ends(i, 0), ends(i, 1)});
  const std::vector<Index> edges = edges_of_curve(mesh(), pairs);
  PointRows rows;
  const double wanted = spacing > 0.0 ? spacing : 0.25 * mesh().typical_edge_length();
  for (const ExactSource& source : sources_along_edges(mesh(), edges, wanted)) rows.add(mesh(), source.point);
  return nb::make_tuple(to_numpy(std::move(rows.vertex)), to_numpy(std::move(rows.face)),
                        to_numpy(std::move(rows.weights)));
}

nb::tuple MeshPoints::path_arrays(const std::vector<ExactPath>& found) const {
  PathArrays arrays(mesh());
  for (const ExactPath& one : found) arrays.add(one.path, one.certified);
  return arrays.take();
}

const SurfaceLocator& MeshPoints::locator() {
  const std::lock_guard lock(mutex_);
  if (!locator_) locator_ = std::make_unique<SurfaceLocator>(mesh_);
  return *locator_;
}

// ---- The functions of _core about a mesh: its check, and what an index would cost

namespace {

nb::tuple finding(const MeshFinding& found) { return nb::make_tuple(found.count, found.first); }

nb::dict check(const VertexArray& vertices, const FaceArray& faces, double gap, bool folds) {
  MeshReport report;
  {
    nb::gil_scoped_release release;
    report = check_mesh(points_of(vertices), triangles_of(faces), {gap, folds});
  }
  nb::list sentences;
  for (const std::string& sentence : report.sentences()) sentences.append(sentence);
  nb::dict findings;
  nb::dict d;
  d["findings"] = findings;
  d["vertices"] = report.vertices;
  d["faces"] = report.faces;
  findings["non_finite_vertices"] = finding(report.non_finite_vertices);
  findings["faces_out_of_range"] = finding(report.faces_out_of_range);
  findings["faces_with_repeated_vertex"] = finding(report.faces_with_repeated_vertex);
  findings["duplicate_faces"] = finding(report.duplicate_faces);
  findings["zero_area_faces"] = finding(report.zero_area_faces);
  findings["duplicate_vertices"] = finding(report.duplicate_vertices);
  findings["isolated_vertices"] = finding(report.isolated_vertices);
  findings["non_manifold_edges"] = finding(report.non_manifold_edges);
  findings["non_manifold_vertices"] = finding(report.non_manifold_vertices);
  findings["inconsistent_edges"] = finding(report.inconsistent_edges);
  findings["outliers"] = finding(report.outliers);
  findings["t_junctions"] = finding(report.t_junctions);
  d["first_t_junction_edge"] =
      nb::make_tuple(report.first_t_junction_edge[0], report.first_t_junction_edge[1]);
  d["outlier_ratio"] = report.outlier_ratio;
  d["first_non_manifold_edge"] =
      nb::make_tuple(report.first_non_manifold_edge[0], report.first_non_manifold_edge[1]);
  d["border_edges"] = report.border_edges;
  nb::list component_vertices;
  for (const MeshComponent& component : report.component_sizes) component_vertices.append(component.vertices);
  d["components"] = report.components;
  d["component_vertices"] = nb::tuple(component_vertices);
  d["border_loops"] = report.border_loops.count;
  d["longest_border_loop"] = report.border_loops.longest_length;
  findings["near_borders"] = nb::make_tuple(report.near_borders.count, report.near_borders.first);
  d["nearest_borders"] = nb::make_tuple(report.near_borders.closest[0], report.near_borders.closest[1]);
  d["near_border_gaps"] = nb::make_tuple(report.near_borders.least, report.near_borders.greatest);
  d["gap_to_join_all"] = report.gap_to_join_all;
  d["joined_borders"] = report.joined_borders;
  d["components_after_bridging"] = report.components_after_bridging;
  d["mean_edge_length"] = report.mean_edge_length;
  d["longest_edge_length"] = report.longest_edge_length;
  d["usable"] = report.usable();
  d["usable_by_index"] = report.usable_by_index();
  d["summary"] = report.summary();
  d["sentences"] = nb::tuple(sentences);
  return d;
}

nb::dict estimate(const VertexArray& vertices, const FaceArray& faces, const SideArray& sides, int threads,
                  std::int64_t memory_budget, nb::object progress) {
  IndexOptions options;
  options.threads = threads;
  options.memory_budget = memory_budget;
  ProgressBridge bridge(progress);
  const BuildEstimate found = bridge.run([&](const Progress& report) {
    return estimate_build(mesh_of(vertices, faces, sides), options, true, report);
  });
  nb::dict d;
  d["build_seconds"] = found.build_seconds;
  d["core_seconds"] = found.core_seconds;
  d["bytes"] = found.bytes;
  d["form"] = to_string(found.form);
  d["field_seconds"] = found.field_seconds;
  d["exact_field_seconds"] = found.exact_field_seconds;
  return d;
}

}  // namespace

void bind_mesh_functions(nb::module_& module) {
  module.def("estimate", &estimate, nb::arg("vertices"), nb::arg("faces"), nb::arg("sides").none(),
             nb::arg("threads"), nb::arg("memory_budget"), nb::arg("progress").none());
  module.def("check_mesh", &check, nb::arg("vertices"), nb::arg("faces"), nb::arg("gap"), nb::arg("folds"));
}

// ---- The functions of _core for metrics, without argument checks

namespace {

using ValueArray = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

std::vector<Tensor> tensors_of(const ValueArray& values) {
  std::vector<Tensor> tensors(values.shape(0) / 9);
  const double* value = values.data();
  for (Tensor& tensor : tensors) {
    for (double& entry : tensor) entry = *value++;
  }
  return tensors;
}

/// Lengths, edges shortened, faces split, and the parts of FaceSplits, or None.
nb::tuple as_tuple(const MetricLengths& found) {
  nb::object splits = nb::none();
  if (!found.splits.empty()) {
    splits =
        nb::make_tuple(flattened(found.splits.middle_of), flattened(found.splits.faces),
                       to_numpy(std::vector<Index>(found.splits.given_face)), flattened(found.splits.sides));
  }
  return nb::make_tuple(flattened(found.sides), found.shortened_edges, found.split_faces, splits);
}

nb::tuple by_cost(const VertexArray& vertices, const FaceArray& faces, const ValueArray& cost) {
  return as_tuple(
      lengths_by_cost(points_of(vertices), triangles_of(faces), std::span(cost.data(), cost.shape(0))));
}

nb::tuple by_tensor(const VertexArray& vertices, const FaceArray& faces, const ValueArray& tensors) {
  return as_tuple(lengths_by_tensor(points_of(vertices), triangles_of(faces), tensors_of(tensors)));
}

DoubleArray slope(const VertexArray& vertices, const FaceArray& faces, double x, double y, double z,
                  double penalty) {
  return to_numpy(slope_cost(points_of(vertices), triangles_of(faces), {x, y, z}, penalty));
}

DoubleArray curvature(const VertexArray& vertices, const FaceArray& faces, double weight) {
  return flattened(curvature_tensors(points_of(vertices), triangles_of(faces), weight));
}

DoubleArray sides_by_cost(const VertexArray& vertices, const FaceArray& faces, const ValueArray& cost) {
  return flattened(
      sides_by_face_cost(points_of(vertices), triangles_of(faces), std::span(cost.data(), cost.shape(0))));
}

DoubleArray sides_by_tensor(const VertexArray& vertices, const FaceArray& faces, const ValueArray& values) {
  return flattened(sides_by_face_tensor(points_of(vertices), triangles_of(faces), tensors_of(values)));
}

Index points_for(const VertexArray& vertices, const FaceArray& faces, const VertexArray& sides) {
  return edge_points_for(points_of(vertices), triangles_of(faces), points_of(sides));
}

}  // namespace

void bind_metrics(nb::module_& module) {
  const nb::arg vertices("vertices"), faces("faces");
  module.def("lengths_by_cost", &by_cost, vertices, faces, nb::arg("cost"));
  module.def("lengths_by_tensor", &by_tensor, vertices, faces, nb::arg("tensors"));
  module.def("sides_by_face_cost", &sides_by_cost, vertices, faces, nb::arg("cost"));
  module.def("sides_by_face_tensor", &sides_by_tensor, vertices, faces, nb::arg("tensors"));
  module.def("edge_points_for", &points_for, vertices, faces, nb::arg("sides"));
  module.def("slope_cost", &slope, vertices, faces, nb::arg("x"), nb::arg("y"), nb::arg("z"),
             nb::arg("penalty"));
  module.def("curvature_tensors", &curvature, vertices, faces, nb::arg("weight"));
}

// ---- The class _core.Points

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
