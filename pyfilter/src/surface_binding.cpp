// The class _core.Surface, without argument checks.
#include "surface_binding.h"

#include <nanobind/stl/string.h>

#include "arrays.h"
#include "index_binding.h"
#include "progress_bridge.h"

namespace vorogeo::python {

namespace {

nb::tuple about(const Answered& answered) {
  return nb::make_tuple(to_string(answered.by), answered.seconds, answered.index_seconds, answered.remark);
}

nb::tuple field(const HeldSurface& self, const PointArrays& source, const ValueArray& offsets,
                double max_distance, int method, nb::object progress) {
  const Mesh& mesh = *self.surface->mesh();
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

/// Calls answer(source, target, answered, progress) for each pair. \return what is known of the last one,
/// with the times of all.
template <class Answer>
nb::tuple for_pairs(const HeldSurface& self, const PointArrays& source, const PointArrays& target,
                    nb::handle progress, Answer&& answer) {
  const Mesh& mesh = *self.surface->mesh();
  const PointList sources = points_on(mesh, points_from(mesh, source), "Source");
  const PointList targets = points_on(mesh, points_from(mesh, target), "Target");
  Answered all;
  ProgressBridge bridge(progress);
  bridge.run([&](const Progress& report) {
    const auto count = static_cast<double>(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
      Answered one;
      const auto at = static_cast<double>(i);
      answer(sources[i], targets[i], one, report.part(at / count, (at + 1.0) / count));
      one.seconds += all.seconds;
      one.index_seconds += all.index_seconds;
      if (one.remark.empty()) one.remark = all.remark;
      all = one;
    }
    return true;
  });
  return about(all);
}

nb::tuple paths(const HeldSurface& self, const PointArrays& source, const PointArrays& target, int method,
                bool exact, nb::object progress) {
  std::vector<ExactPath> found;
  const nb::tuple answered = for_pairs(
      self, source, target, progress,
      [&](const SurfacePoint& from, const SurfacePoint& to, Answered& one, const Progress& report) {
        found.push_back(self.surface->path(from, to, static_cast<AnswerMethod>(method), exact, one, report));
      });
  return nb::make_tuple(self.points->path_arrays(found), answered);
}

nb::tuple distances(const HeldSurface& self, const PointArrays& source, const PointArrays& target, int method,
                    nb::object progress) {
  std::vector<double> found;
  const nb::tuple answered = for_pairs(
      self, source, target, progress,
      [&](const SurfacePoint& from, const SurfacePoint& to, Answered& one, const Progress& report) {
        found.push_back(self.surface->distance(from, to, static_cast<AnswerMethod>(method), one, report));
      });
  return nb::make_tuple(to_numpy(std::move(found)), answered);
}

nb::object index_of(const HeldSurface& self, const std::shared_ptr<const GeodesicIndex>& index) {
  return index ? index_object(index, self.input_faces, self.threads) : nb::none();
}

}  // namespace

void bind_surface(nb::module_& module) {
  const auto progress = nb::arg("progress").none();
  nb::class_<HeldSurface>(module, "Surface")
      .def(
          "__init__",
          [](HeldSurface* self, const VertexArray& vertices, const FaceArray& faces, const SideArray& sides,
             int threads, std::int64_t memory_budget, double gap, bool folds, nb::handle built) {
            const std::size_t rows = faces.shape(0);
            const auto index = built.is_none() ? nullptr : held_index(built).index;
            nb::gil_scoped_release release;
            IndexOptions options;
            options.threads = threads;
            options.memory_budget = memory_budget;
            auto mesh = index ? index->mesh() : mesh_of(vertices, faces, sides, {gap, folds});
            auto points = std::make_shared<MeshPoints>(mesh);
            auto surface = std::make_shared<Surface>(mesh, index, RentOrBuy(mesh->vertex_count()), options);
            new (self) HeldSurface{std::move(surface), std::move(points), threads, rows};
          },
          nb::arg("vertices"), nb::arg("faces"), nb::arg("sides").none(), nb::arg("threads"),
          nb::arg("memory_budget"), nb::arg("gap"), nb::arg("folds"), nb::arg("index").none())
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
      .def("field", &field, nb::arg("sources"), nb::arg("offsets"), nb::arg("max_distance"),
           nb::arg("method"), progress)
      .def("paths", &paths, nb::arg("sources"), nb::arg("targets"), nb::arg("method"), nb::arg("exact"),
           progress)
      .def("distances", &distances, nb::arg("sources"), nb::arg("targets"), nb::arg("method"), progress)
      .def("index", [](const HeldSurface& self) { return index_of(self, self.surface->index()); })
      .def(
          "build_index",
          [](const HeldSurface& self, nb::object report) {
            ProgressBridge bridge(report);
            const auto index =
                bridge.run([&](const Progress& inner) { return self.surface->build_index(inner); });
            return index_of(self, index);
          },
          progress);
}

}  // namespace vorogeo::python
