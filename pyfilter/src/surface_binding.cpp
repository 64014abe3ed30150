// The class _core.Surface: a surface with its queries, without argument checks.
#include "surface_binding.h"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <filesystem>
#include <optional>

#include "arrays.h"
#include "mesh/given_points.h"
#include "query/landmarks.h"
#include "query/surface.h"

namespace vorogeo::python {

nb::tuple about(const Answered& answered) {
  return nb::make_tuple(to_string(answered.by), answered.seconds, answered.index_seconds, answered.remark);
}

namespace {

HeldSurface held(std::shared_ptr<Surface> surface, std::size_t input_faces) {
  auto points = std::make_shared<MeshPoints>(surface->mesh());
  return {std::move(surface), std::move(points), input_faces};
}

HeldSurface without_index(const VertexArray& vertices, const FaceArray& faces, const SideArray& sides,
                          int threads, std::int64_t memory_budget, double gap, bool folds) {
  nb::gil_scoped_release release;
  IndexOptions options;
  options.threads = threads;
  options.memory_budget = memory_budget;
  return held(std::make_shared<Surface>(mesh_of(vertices, faces, sides, {gap, folds}), options),
              faces.shape(0));
}

HeldSurface build(const VertexArray& vertices, const FaceArray& faces, const SideArray& sides,
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
  return held(std::make_shared<Surface>(std::move(index), threads), faces.shape(0));
}

HeldSurface load(const std::filesystem::path& file, const VertexArray& vertices, const FaceArray& faces,
                 const SideArray& sides, int threads, double gap, bool folds, bool mapped) {
  nb::gil_scoped_release release;
  auto index = GeodesicIndex::load(file, mesh_of(vertices, faces, sides, {gap, folds}),
                                   mapped ? TableStorage::mapped : TableStorage::copied);
  return held(std::make_shared<Surface>(std::move(index), threads), faces.shape(0));
}

bool has_index(const HeldSurface& self) { return self.surface->index() != nullptr; }

void build_index(const HeldSurface& self, nb::object progress) {
  ProgressBridge bridge(progress);
  bridge.run([&](const Progress& report) { return self.surface->build_index(report) != nullptr; });
}

void save(const HeldSurface& self, const std::filesystem::path& file) {
  nb::gil_scoped_release release;
  self.surface->index()->save(file);
}

/// Patches by input face, of one in parts that at its centre; no_index for a face that the mesh leaves out.
IndexArray face_patches(const HeldSurface& self, int layer) {
  const auto index = self.surface->index();
  const std::span<const Index> patches = index->face_patches(layer);
  std::vector<Index> values(self.input_faces, no_index);
  for (Index f : central_parts(self.mesh())) values[self.mesh().input_face(f)] = patches[f];
  return to_numpy(std::move(values));
}

nb::dict statistics(const HeldSurface& self) {
  const Mesh& mesh = self.mesh();
  const auto index = self.surface->index();
  const IndexStatistics& s = index->statistics();
  Index faces = 0;
  for (Index f = 0; f < mesh.first_bridge(); ++f) {
    faces += f == 0 || mesh.input_face(f) != mesh.input_face(f - 1);
  }
  nb::dict d;
  d["vertices"] = s.vertices;
  d["faces"] = faces;
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

/// The distance of two vertices that are in range, with as little around it as possible.
double vertex_distance(const HeldSurface& self, Index source, Index target) {
  nb::gil_scoped_release release;
  return self.surface->lend([&](Query& query) {
    return query.distance(SurfacePoint::at_vertex(source), SurfacePoint::at_vertex(target),
                          AnswerMethod::index);
  });
}

nb::tuple field(const HeldSurface& self, const PointArrays& source, const ValueArray& offsets,
                double max_distance, int method, nb::object progress) {
  const Mesh& mesh = self.mesh();
  const PointList points = points_on(mesh, points_from(mesh, source), "Source");
  std::vector<ExactSource> sources;
  for (std::size_t i = 0; i < points.size(); ++i) sources.push_back({points[i], offsets.data()[i]});
  Answered answered;
  ProgressBridge bridge(progress);
  LabelledField found = bridge.run([&](const Progress& report) {
    return self.surface->field(sources, max_distance, static_cast<AnswerMethod>(method), answered, report);
  });
  return nb::make_tuple(of_given_vertices(mesh, std::move(found.distance)),
                        of_given_vertices(mesh, std::move(found.source)), about(answered));
}

nb::tuple paths(const HeldSurface& self, const PointArrays& source, const PointArrays& target, int method,
                bool exact, bool certify, nb::object progress) {
  const PointList sources = points_from(self.mesh(), source);
  const PointList targets = points_from(self.mesh(), target);
  Answered answered;
  ProgressBridge bridge(progress);
  const auto found = bridge.run([&](const Progress& report) {
    return self.surface->paths({sources, targets}, static_cast<AnswerMethod>(method), {exact, certify},
                               answered, report);
  });
  return nb::make_tuple(self.points->path_arrays(found), about(answered));
}

nb::tuple distances(const HeldSurface& self, const PointArrays& source, const PointArrays& target, int method,
                    nb::object progress) {
  const PointList sources = points_from(self.mesh(), source);
  const PointList targets = points_from(self.mesh(), target);
  Answered answered;
  ProgressBridge bridge(progress);
  auto found = bridge.run([&](const Progress& report) {
    return self.surface->distances({sources, targets}, static_cast<AnswerMethod>(method), answered, report);
  });
  return nb::make_tuple(to_numpy(std::move(found)), about(answered));
}

/// Narrows the corridors of certified paths from this call on. \return the memory that the landmarks take,
/// in bytes.
std::size_t use_landmarks(const HeldSurface& self, int count, nb::object progress) {
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

void bind_surface(nb::module_& module) {
  const nb::arg vertices("vertices"), faces("faces"), threads("threads"), memory_budget("memory_budget"),
      gap("gap"), folds("folds"), sources("sources"), targets("targets"), method("method"), file("file");
  const auto sides = nb::arg("sides").none();
  const auto progress = nb::arg("progress").none();
  nb::class_<HeldSurface>(module, "Surface")
      .def_static("without_index", &without_index, vertices, faces, sides, threads, memory_budget, gap, folds)
      .def_static("build", &build, vertices, faces, sides, nb::arg("first_layer_patches"),
                  nb::arg("second_layer_patches"), nb::arg("delta"), threads, nb::arg("seed"), memory_budget,
                  gap, folds, nb::arg("file").none(), progress)
      .def_static("load", &load, file, vertices, faces, sides, threads, gap, folds, nb::arg("mapped"))
      .def("has_index", &has_index)
      .def("build_index", &build_index, progress)
      .def("save", &save, file)
      .def("face_patches", &face_patches, nb::arg("layer"))
      .def("statistics", &statistics)
      .def("vertex_distance", &vertex_distance, nb::arg("source"), nb::arg("target"))
      .def(
          "snap",
          [](const HeldSurface& self, const VertexArray& points) { return self.points->snap(points); },
          nb::arg("points"))
      .def(
          "along_edges",
          [](const HeldSurface& self, const EdgeArray& ends, double spacing) {
            return self.points->along_edges(ends, spacing);
          },
          nb::arg("ends"), nb::arg("spacing"))
      .def("field", &field, sources, nb::arg("offsets"), nb::arg("max_distance"), method, progress)
      .def("paths", &paths, sources, targets, method, nb::arg("exact"), nb::arg("certify"), progress)
      .def("distances", &distances, sources, targets, method, progress)
      .def("use_landmarks", &use_landmarks, nb::arg("count"), progress);
}

}  // namespace vorogeo::python
