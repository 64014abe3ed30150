// The class _core.Surface: a surface with its queries, without argument checks.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>

#include <filesystem>
#include <optional>

#include "bindings.h"
#include "index/geodesic_index.h"
#include "query/landmarks.h"

namespace vorogeo::python {

namespace {

// ---- How a surface is made, and its index

PythonSurface without_index(const PythonMesh& self, int threads, std::int64_t memory_budget) {
  IndexOptions options;
  options.threads = threads;
  options.memory_budget = memory_budget;
  return {self, std::make_shared<Surface>(self.mesh, options)};
}

PythonSurface with_index(const PythonMesh& self, Index first_layer_patches, Index second_layer_patches,
                         double delta, int threads, std::uint64_t seed, std::int64_t memory_budget,
                         const std::optional<std::filesystem::path>& file, nb::object progress) {
  const IndexOptions options{.first_layer_patches = first_layer_patches,
                             .second_layer_patches = second_layer_patches,
                             .delta = delta,
                             .threads = threads,
                             .seed = seed,
                             .memory_budget = memory_budget};
  ProgressBridge bridge(progress);
  auto index = bridge.run([&](const Progress& report) {
    const Progress rest = report.part(0.01, 1.0);  // the mesh has been read
    return file ? GeodesicIndex::build_in_file(*file, self.mesh, options, rest)
                : GeodesicIndex::build(self.mesh, options, rest);
  });
  return {self, std::make_shared<Surface>(std::move(index), threads)};
}

PythonSurface load_index(const PythonMesh& self, const std::filesystem::path& file, int threads,
                         bool mapped) {
  nb::gil_scoped_release release;
  auto index = GeodesicIndex::load(file, self.mesh, mapped ? TableStorage::mapped : TableStorage::copied);
  return {self, std::make_shared<Surface>(std::move(index), threads)};
}

bool has_index(const PythonSurface& self) { return self.surface->index() != nullptr; }

void build_index(const PythonSurface& self, nb::object progress) {
  ProgressBridge bridge(progress);
  bridge.run([&](const Progress& report) { return self.surface->build_index(report) != nullptr; });
}

/// The surface that answers for the ways back: distances to points instead of from them.
PythonSurface reversed(const PythonSurface& self) {
  nb::gil_scoped_release release;
  return {self.python_mesh, {self.surface, &self.surface->reversed()}};
}

void save(const PythonSurface& self, const std::filesystem::path& file) {
  nb::gil_scoped_release release;
  self.surface->index()->save(file);
}

Values<Index> face_patches(const PythonSurface& self, int layer) {
  const auto index = self.surface->index();
  return to_numpy(InputMap(self.mesh()).of_faces(index->face_patches(layer), no_index));
}

nb::dict statistics(const PythonSurface& self) {
  const Mesh& mesh = self.mesh();
  const auto index = self.surface->index();
  const IndexStatistics& s = index->statistics();
  nb::dict d;
  d["vertices"] = s.vertices;
  d["faces"] = InputMap(mesh).central_parts().size();
  d["bridges"] = mesh.face_count() - mesh.first_bridge();
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

// ---- Questions

/// The distance of two vertices from the index, with as little overhead as possible. \pre Both exist.
std::pair<double, double> vertex_distance(const PythonSurface& self, Index source, Index target) {
  nb::gil_scoped_release release;
  const Stopwatch watch;
  const double found = self.surface->lend([&](Query& query) {
    return query.distance(SurfacePoint::at_vertex(source), SurfacePoint::at_vertex(target), Answer::index);
  });
  return {found, watch.seconds()};
}

auto field(const TaskOptions& how, const PythonSurface& self, const PointArrays& source,
           const ValueArray& offsets, double max_distance) {
  const PointList points = points_on(self.mesh(), self.points(source), "Source");
  std::vector<ExactSource> sources;
  for (std::size_t i = 0; i < points.size(); ++i) sources.push_back({points[i], offsets(i)});
  auto found = self.surface->field(sources, max_distance, how.by, *how.answered, how.progress);
  const InputMap map(self.mesh());
  return std::tuple(map.of_vertices(std::move(found.distance)), map.of_vertices(std::move(found.source)));
}

auto distances(const TaskOptions& how, const PythonSurface& self, const PointArrays& source,
               const PointArrays& target) {
  const PointList sources = self.points(source), targets = self.points(target);
  return std::tuple(self.surface->distances({sources, targets}, how.by, *how.answered, how.progress));
}

auto paths(const TaskOptions& how, const PythonSurface& self, const PointArrays& source,
           const PointArrays& target, bool exact, bool certify) {
  const PointList sources = self.points(source), targets = self.points(target);
  return paths_of(
      self, self.surface->paths({sources, targets}, how.by, {exact, certify}, *how.answered, how.progress));
}

/// Computes landmarks, and the index if there is none: they narrow the corridors of later certified paths.
/// \return the memory that the landmarks take, in bytes.
std::size_t use_landmarks(const PythonSurface& self, int count, nb::object progress) {
  ProgressBridge bridge(progress);
  return bridge.run([&](const Progress& report) {
    Surface& surface = *self.surface;
    const bool builds = surface.index() == nullptr;
    const auto index = surface.build_index(report.part(0.0, 0.8));
    const Progress rest = builds ? report.part(0.8, 1.0) : report;
    auto made = landmarks_of(index, count, surface.threads(), rest);
    const std::size_t bytes = made->memory_bytes();
    surface.use_landmarks(std::move(made));
    return bytes;
  });
}

}  // namespace

void bind_surface(nb::class_<PythonMesh>& mesh, nb::class_<PythonSurface>& surface) {
  mesh.def("surface", &without_index)
      .def("surface_with_index", &with_index, nb::arg("first_layer_patches"), nb::arg("second_layer_patches"),
           nb::arg("delta"), nb::arg("threads"), nb::arg("seed"), nb::arg("memory_budget"),
           nb::arg("file").none(), nb::arg("progress").none())
      .def("load_index", &load_index);
  surface.def_ro("mesh", &PythonSurface::python_mesh)
      .def("has_index", &has_index)
      .def("reversed", &reversed)
      .def("build_index", &build_index, nb::arg("progress").none())
      .def("save", &save)
      .def("face_patches", &face_patches)
      .def("statistics", &statistics)
      .def("vertex_distance", &vertex_distance)
      .def("use_landmarks", &use_landmarks, nb::arg("count"), nb::arg("progress").none());
  bind_question(surface, "field", &field);
  bind_question(surface, "paths", &paths);
  bind_question(surface, "distances", &distances);
}

}  // namespace vorogeo::python
