// Meshes: how they are read, metrics on them, points in space and curves, checks, and what an index would
// cost.
#include <optional>
#include <string>

#include "bindings.h"
#include "index/build_cost.h"
#include "mesh/gaps.h"
#include "mesh/mesh_check.h"
#include "mesh/metric.h"
#include "mesh/one_way.h"
#include "tasks/curve_sources.h"
#include "tasks/surface_lines.h"

namespace vorogeo::python {

namespace {

// ---- Reading a mesh

/// The arrays of FaceSplits: middle_of, faces, given_face, sides.
using SplitArrays = std::tuple<EdgeArray, FaceArray, IdArray, VertexArray>;

/// Lengths of the sides of the faces, each opposite its corner; the number of points on each edge if its
/// faces may disagree on its length (0: they agree); the faces that are split; and drifts along the sides.
/// None: lengths in space.
using SideArrays =
    std::optional<std::tuple<VertexArray, Index, std::optional<SplitArrays>, std::optional<VertexArray>>>;

/// Splits of the faces of a mesh with `vertices` vertices and `given_faces` faces. \throw InvalidInput for
/// vertices and faces that do not exist, and for arrays of unequal length: a user may write a metric.
FaceSplits splits_of(const SplitArrays& arrays, std::size_t vertices, std::size_t given_faces) {
  const auto& [middle_of, faces, given_face, sides] = arrays;
  auto require = [](bool holds, const char* part, std::size_t row, const char* wanted) {
    if (holds) return;
    throw InvalidInput("splits." + std::string(part) + ": row " + std::to_string(row) + " is wrong; give " +
                       wanted + ".");
  };
  auto is_below = [](Index number, std::size_t end) {
    return number >= 0 && static_cast<std::size_t>(number) < end;
  };
  for (std::size_t i = 0; i < middle_of.shape(0); ++i) {
    require(is_below(middle_of(i, 0), vertices + i) && is_below(middle_of(i, 1), vertices + i), "middle_of",
            i, "two vertices that come before the one in their middle");
  }
  const std::size_t count = faces.shape(0);
  if (given_face.shape(0) != count || sides.shape(0) != count) {
    throw InvalidInput("splits: has " + std::to_string(count) + " faces, but " +
                       std::to_string(given_face.shape(0)) + " given faces and lengths of " +
                       std::to_string(sides.shape(0)) + "; give one of each for each face.");
  }
  for (std::size_t f = 0; f < count; ++f) {
    for (int i = 0; i < 3; ++i) {
      require(is_below(faces(f, i), vertices + middle_of.shape(0)), "faces", f, "vertices given or added");
    }
    require(is_below(given_face(f), given_faces) && (f == 0 || given_face(f - 1) <= given_face(f)),
            "given_face", f, "numbers of the faces given, in ascending order");
  }
  const std::span<const Index> given = values_of(given_face);
  return {rows_of<2>(middle_of), rows_of<3>(faces), {given.begin(), given.end()}, rows_of<3>(sides)};
}

/// The share of reading the mesh in the progress of a build.
constexpr double reading_share = 0.01;

PythonMesh read_mesh(const VertexArray& vertices, const FaceArray& faces, const SideArrays& sides, double gap,
                     bool folds, nb::object progress) {
  ProgressBridge bridge(progress);
  return bridge.run([&](const Progress& report) -> PythonMesh {
    const Watch watch(report.part(0.0, reading_share), "Reading the mesh");
    MeshInput input{rows_of<3>(vertices), rows_of<3>(faces), {}, {gap, folds}};
    if (sides) {
      const auto& [lengths, points_per_edge, splits, drifts] = *sides;
      input.metric = {rows_of<3>(lengths), points_per_edge};
      if (drifts) input.metric.drifts = rows_of<3>(*drifts);
      if (splits) input.metric.splits = splits_of(*splits, vertices.shape(0), faces.shape(0));
    }
    return {measured_mesh(std::move(input))};
  });
}

// ---- Points and curves on a mesh

/// Nearest points of the surface: faces, weights, distances.
auto snap(const PythonMesh& self, const VertexArray& points) {
  PointColumns columns;
  std::vector<double> distances;
  {
    nb::gil_scoped_release release;
    for (const Point& point : rows_of<3>(points)) {
      const SnappedPoint found = self.located().nearest(point);
      distances.push_back(found.distance);
      columns.add(*self.mesh, found.point);
    }
  }
  return std::tuple(to_numpy(std::move(columns.face)), to_numpy(std::move(columns.weights)),
                    to_numpy(std::move(distances)));
}

/// Points along the edges between pairs of vertices, at most `spacing` apart; 0: a quarter of the typical
/// edge. \throw InvalidInput if the mesh has no such edge.
auto along_edges(const PythonMesh& self, const EdgeArray& ends, double spacing) {
  const Mesh& mesh = *self.mesh;
  const std::vector<Index> edges = edges_of_curve(mesh, rows_of<2>(ends));
  const double wanted = spacing > 0.0 ? spacing : 0.25 * mesh.typical_edge_length();
  PointColumns columns;
  for (const ExactSource& source : sources_along_edges(mesh, edges, wanted)) columns.add(mesh, source.point);
  return to_python(std::move(columns));
}

/// The lines that edges form, each as the numbers of its points in order.
nb::list ordered_lines(const EdgeArray& edges) {
  nb::list lines;
  for (auto& line : lines_in_order(rows_of<2>(edges), [](Index p) { return "point " + std::to_string(p); })) {
    lines.append(to_numpy(std::move(line)));
  }
  return lines;
}

// ---- Checks, and what an index would cost

nb::dict check(const VertexArray& vertices, const FaceArray& faces, double gap, bool folds) {
  MeshReport report;
  {
    nb::gil_scoped_release release;
    report = check_mesh(rows_of<3>(vertices), rows_of<3>(faces), {gap, folds});
  }
  nb::list sentences, component_vertices;
  for (const std::string& sentence : report.sentences()) sentences.append(sentence);
  for (const MeshComponent& component : report.component_sizes) component_vertices.append(component.vertices);
  auto pair = [](const auto& two) { return nb::make_tuple(two[0], two[1]); };
  nb::dict findings;
  auto add = [&](const char* name, const auto& found) {
    findings[name] = nb::make_tuple(found.count, found.first);
  };
  add("non_finite_vertices", report.non_finite_vertices);
  add("faces_out_of_range", report.faces_out_of_range);
  add("faces_with_repeated_vertex", report.faces_with_repeated_vertex);
  add("duplicate_faces", report.duplicate_faces);
  add("zero_area_faces", report.zero_area_faces);
  add("duplicate_vertices", report.duplicate_vertices);
  add("isolated_vertices", report.isolated_vertices);
  add("non_manifold_edges", report.non_manifold_edges);
  add("non_manifold_vertices", report.non_manifold_vertices);
  add("inconsistent_edges", report.inconsistent_edges);
  add("rounded_edges", report.rounded_edges);
  add("outliers", report.outliers);
  add("t_junctions", report.t_junctions);
  add("near_borders", report.near_borders);
  nb::dict d;
  d["findings"] = findings;
  d["vertices"] = report.vertices;
  d["faces"] = report.faces;
  d["outlier_ratio"] = report.outlier_ratio;
  d["first_non_manifold_edge"] = pair(report.first_non_manifold_edge);
  d["first_t_junction_edge"] = pair(report.first_t_junction_edge);
  d["border_edges"] = report.border_edges;
  d["border_loops"] = report.border_loops.count;
  d["longest_border_loop"] = report.border_loops.longest_length;
  d["components"] = report.components;
  d["component_vertices"] = nb::tuple(component_vertices);
  d["nearest_borders"] = pair(report.near_borders.closest);
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

nb::dict estimate(const PythonMesh& self, int threads, std::int64_t memory_budget, nb::object progress) {
  IndexOptions options;
  options.threads = threads;
  options.memory_budget = memory_budget;
  ProgressBridge bridge(progress);
  const BuildEstimate found =
      bridge.run([&](const Progress& report) { return estimate_build(self.mesh, options, report); });
  nb::dict d;
  d["build_seconds"] = found.build_seconds;
  d["core_seconds"] = found.core_seconds;
  d["bytes"] = found.bytes;
  d["form"] = to_string(found.form);
  d["field_seconds"] = found.field_seconds;
  d["exact_field_seconds"] = found.exact_field_seconds;
  return d;
}

// ---- Metrics: lengths by costs and tensors, and costs and tensors that follow from the shape

using SideRows = Rows<double, 3>;
using SplitRows = std::tuple<Rows<Index, 2>, Rows<Index, 3>, Values<Index>, SideRows>;

}  // namespace

/// Lengths of sides, numbers of shortened edges and of split faces, and the arrays of FaceSplits or None.
static std::tuple<SideRows, Index, Index, std::optional<SplitRows>> to_python(Metric&& found) {
  std::optional<SplitRows> splits;
  if (!found.splits.empty()) {
    FaceSplits& own = found.splits;
    splits.emplace(to_numpy(std::move(own.middle_of)), to_numpy(std::move(own.faces)),
                   to_numpy(std::move(own.given_face)), to_numpy(std::move(own.sides)));
  }
  return {to_numpy(std::move(found.sides)), found.shortened_edges, found.split_faces, std::move(splits)};
}

/// Tensors, row by row, and drifts.
static auto to_python(Randers&& found) {
  return std::tuple(to_numpy(std::move(found.tensors)), to_numpy(std::move(found.drifts)));
}

namespace {

/// A Python function of an array of grades, to be called while the GIL is held.
CostOfGrade for_core(const nb::callable& cost) {
  return [&cost](std::span<const double> grades) {
    const nb::object found = cost(to_numpy(std::vector<double>(grades.begin(), grades.end())));
    const auto costs = values_of(nb::cast<ValueArray>(found));
    return std::vector<double>(costs.begin(), costs.end());
  };
}

Values<double> costs_at(const CostOfGrade& cost, const ValueArray& grades) {
  return to_numpy(cost(values_of(grades)));
}

// The arguments of functions for metrics, as the core takes them.
std::span<const double> for_core(const ValueArray& values) { return values_of(values); }
auto for_core(const VertexArray& rows) { return rows_of<3>(rows); }
auto for_core(const TensorArray& tensors) { return rows_of<9>(tensors); }
Point for_core(const PointArray& point) { return {point(0), point(1), point(2)}; }
double for_core(double number) { return number; }

/// Binds function(positions, faces, arguments...), whose arguments come from Python as `Arguments`.
template <class... Arguments, class Function>
void bind_metric(nb::module_& module, const char* name, Function function) {
  module.def(name, [function](const VertexArray& vertices, const FaceArray& faces, Arguments... arguments) {
    return to_python(function(rows_of<3>(vertices), rows_of<3>(faces), for_core(arguments)...));
  });
}

}  // namespace

void bind_mesh(nb::class_<PythonMesh>& mesh, nb::module_& module) {
  module.def("read_mesh", &read_mesh, nb::arg("vertices"), nb::arg("faces"), nb::arg("sides").none(),
             nb::arg("gap"), nb::arg("folds"), nb::arg("progress").none());
  module.def("check_mesh", &check);
  module.def("lines_in_order", &ordered_lines);
  mesh.def("snap", &snap)
      .def("along_edges", &along_edges)
      .def("estimate", &estimate, nb::arg("threads"), nb::arg("memory_budget"), nb::arg("progress").none());
  bind_metric<const ValueArray&>(module, "lengths_by_cost", lengths_by_cost);
  bind_metric<const TensorArray&>(module, "lengths_by_tensor", lengths_by_tensor);
  bind_metric<const ValueArray&>(module, "sides_by_face_cost", sides_by_face_cost);
  bind_metric<const TensorArray&>(module, "sides_by_face_tensor", sides_by_face_tensor);
  bind_metric<const VertexArray&>(module, "edge_points_for", edge_points_for);
  bind_metric<const VertexArray&, const VertexArray&>(module, "drifts_by_face", drifts_by_face);
  bind_metric<const PointArray&, double>(module, "slope_cost", slope_cost);
  bind_metric<const PointArray&>(module, "grades_of", grades_of);
  bind_metric<double>(module, "curvature_tensors", curvature_tensors);
  bind_metric<const VertexArray&, const ValueArray&>(module, "travel_time", travel_time);
  bind_metric<const nb::callable&, const PointArray&>(module, "hiking_time", hiking_time);
  module.def("tobler", [](const ValueArray& grades) { return costs_at(for_each_grade(tobler), grades); });
  module.def("naismith", [](const ValueArray& grades) { return costs_at(for_each_grade(naismith), grades); });
  module.def("climbing_cost", [](const ValueArray& grades, double uphill, double downhill) {
    return costs_at(climbing_cost(uphill, downhill), grades);
  });
}

}  // namespace vorogeo::python
