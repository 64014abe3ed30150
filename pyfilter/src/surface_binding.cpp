// Surfaces, and the tasks on them.
#include "surface_binding.h"

#include <nanobind/stl/string.h>

#include "arrays.h"
#include "index_binding.h"
#include "mesh/given_points.h"
#include "mesh/outliers.h"
#include "progress_bridge.h"
#include "tasks/extent.h"
#include "tasks/spread_points.h"
#include "tasks/surface_lines.h"
#include "tasks/voronoi_regions.h"
#include "tasks_binding.h"

namespace vorogeo::python {

// ---- The class _core.Surface, without argument checks

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

// ---- The functions of _core for what is built on distance fields

namespace {

using FieldArray = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

std::span<const double> values_of(const FieldArray& values) { return {values.data(), values.shape(0)}; }

/// Values at the centres of faces, by row of the faces given; no_index for a face that was left out.
IndexArray by_input_face(const HeldIndex& held, const std::vector<Index>& of_face) {
  std::vector<Index> values(held.input_faces, no_index);
  const Mesh& mesh = *held.index->mesh();
  for (Index f : central_parts(mesh)) values[mesh.input_face(f)] = of_face[f];
  return to_numpy(std::move(values));
}

/// Vertices, faces and weights of points.
nb::tuple rows_of(nb::handle index, const std::vector<SurfacePoint>& points) {
  const HeldIndex held = held_index(index);
  PointRows rows;
  for (const SurfacePoint& point : points) rows.add(*held.index->mesh(), point);
  return nb::make_tuple(to_numpy(std::move(rows.vertex)), to_numpy(std::move(rows.face)),
                        to_numpy(std::move(rows.weights)));
}

nb::tuple voronoi(nb::handle index, const PointArrays& points, bool exact, nb::object progress) {
  VoronoiRegions found = with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    return voronoi_regions(team, points_from(team.mesh(), points), report);
  });
  const Mesh& mesh = *held_index(index).index->mesh();
  return nb::make_tuple(of_given_vertices(mesh, std::move(found.vertex_region)),
                        of_given_vertices(mesh, std::move(found.distance)),
                        by_input_face(held_index(index), found.face_region), to_numpy(std::move(found.area)),
                        flattened(found.borders.points), flattened(found.borders.segments),
                        flattened(found.border_regions));
}

nb::tuple iso(nb::handle index, const FieldArray& field, const FieldArray& levels, int interpolation) {
  const HeldIndex held = held_index(index);
  Isolines found;
  {
    nb::gil_scoped_release release;
    found = isolines(*held.index->mesh(), values_of(field), values_of(levels),
                     static_cast<Interpolation>(interpolation));
  }
  return nb::make_tuple(flattened(found.lines.points), flattened(found.lines.segments),
                        to_numpy(std::move(found.level_of_point)));
}

nb::tuple farthest(nb::handle index, Index count, double radius, const PointArrays& start, std::uint64_t seed,
                   bool exact, nb::object progress) {
  FarthestSamples found = with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    return sample_farthest(team, {count, radius}, points_from(team.mesh(), start), seed, report);
  });
  return nb::make_tuple(rows_of(index, found.points), to_numpy(std::move(found.radius)),
                        to_numpy(std::move(found.distance)), found.covering_radius);
}

IndexArray poisson_disk(nb::handle index, double radius, std::uint64_t seed, bool exact,
                        nb::object progress) {
  return to_numpy(with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    return sample_poisson_disk(team, radius, seed, report);
  }));
}

nb::tuple disk(nb::handle index, const PointArrays& sources, double radius, bool exact) {
  GeodesicDisk found = with_team(index, exact, nb::none(), [&](FieldTeam& team, const Progress&) {
    return geodesic_disk(team, points_from(team.mesh(), sources), radius);
  });
  const Mesh& mesh = *held_index(index).index->mesh();
  for (Index& face : found.faces) face = mesh.input_face(face);
  return nb::make_tuple(to_numpy(std::move(found.vertices)), to_numpy(std::move(found.distance)),
                        to_numpy(std::move(found.faces)));
}

nb::tuple eccentricity(nb::handle index, const PointArrays& points, bool exact, nb::object progress) {
  const auto found = with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    return eccentricities(team, points_from(team.mesh(), points), report);
  });
  std::vector<double> distance;
  std::vector<Index> vertex;
  for (const Eccentricity& one : found) {
    distance.push_back(one.distance);
    vertex.push_back(one.farthest);
  }
  return nb::make_tuple(to_numpy(std::move(distance)), to_numpy(std::move(vertex)));
}

/// `start`: no_index for the largest component.
nb::tuple extent(nb::handle index, Index start, Index max_fields, bool exact, nb::object progress) {
  const Extent found = with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    const Index first = start == no_index ? largest_component(team.mesh()).first_vertex : start;
    return extent_of_component(team, first, max_fields, report);
  });
  return nb::make_tuple(nb::make_tuple(found.diameter.lower, found.diameter.upper),
                        nb::make_tuple(found.ends[0], found.ends[1]),
                        nb::make_tuple(found.radius.lower, found.radius.upper), found.centre, found.fields);
}

nb::tuple relax(nb::handle index, const PointArrays& points, Index rounds, bool exact, nb::object progress) {
  RelaxedPoints found = with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    return relax_points(team, points_from(team.mesh(), points), rounds, report);
  });
  return nb::make_tuple(rows_of(index, found.points), to_numpy(std::move(found.energy)));
}

}  // namespace

void bind_surface_tasks(nb::module_& module) {
  const nb::arg index("index"), points("points"), sources("sources"), radius("radius"), seed("seed"),
      exact("exact");
  const auto progress = nb::arg("progress").none();
  module.def("voronoi", &voronoi, index, points, exact, progress);
  module.def("isolines", &iso, index, nb::arg("field"), nb::arg("levels"), nb::arg("interpolation"));
  module.def("sample_farthest", &farthest, index, nb::arg("count"), radius, nb::arg("start"), seed, exact,
             progress);
  module.def("sample_poisson_disk", &poisson_disk, index, radius, seed, exact, progress);
  module.def("disk", &disk, index, sources, radius, exact);
  module.def("eccentricity", &eccentricity, index, points, exact, progress);
  module.def("extent", &extent, index, nb::arg("start"), nb::arg("max_fields"), exact, progress);
  module.def("relax", &relax, index, points, nb::arg("rounds"), exact, progress);
}

}  // namespace vorogeo::python
