// Tasks on a surface: matrices, regions, samplings, lines; files of results.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>

#include <optional>
#include <span>
#include <variant>

#include "bindings.h"
#include "mesh/outliers.h"
#include "support/file.h"
#include "support/memory.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/neighbors.h"
#include "tasks/spread_points.h"
#include "tasks/surface_lines.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo::python {

namespace {

using OptionalPoints = std::optional<PointArrays>;

// ---- Matrices and neighbours

/// Memory of the caller, such as an array or a mapped file, in double or single precision.
template <class Entry>
using OutArray = nb::ndarray<Entry, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

template <class Entry>
std::span<Entry> entries_of(const OutArray<Entry>& out) {
  return {out.data(), out.shape(0) * out.shape(1)};
}

/// Without `columns`, those of the rows.
template <class Entry>
std::tuple<About> fill_matrix(const HeldSurface& held, const PointArrays& rows, const OptionalPoints& columns,
                              int entries, const OutArray<Entry>& out, int method, nb::object progress) {
  auto filled = ask(method, progress, [&](const TaskOptions& options) {
    const auto how = static_cast<MatrixMethod>(entries);
    if (columns) {
      distance_matrix(*held.surface, held.points(rows), held.points(*columns), how, entries_of(out), options);
    } else {
      distance_matrix(*held.surface, held.points(rows), how, entries_of(out), options);
    }
    return std::monostate{};
  });
  return {std::move(filled.second)};
}

template <class Entry>
std::tuple<About> fill_fields(const HeldSurface& held, const PointArrays& sources, double max_distance,
                              const OutArray<Entry>& out, int method, nb::object progress) {
  auto filled = ask(method, progress, [&](const TaskOptions& options) {
    distance_fields(*held.surface, held.points(sources), max_distance, entries_of(out), options);
    return std::monostate{};
  });
  return {std::move(filled.second)};
}

/// Where rows begin, columns, distances. Without `others`, pairs of `points`.
auto within(const HeldSurface& held, const PointArrays& points, const OptionalPoints& others, double radius,
            std::int64_t max_bytes, int method, nb::object progress) {
  auto [found, answered] = ask(method, progress, [&](const TaskOptions& options) {
    const PointList from = held.points(points);
    return others ? pairs_within(*held.surface, from, held.points(*others), radius, max_bytes, options)
                  : pairs_within(*held.surface, from, radius, max_bytes, options);
  });
  return std::tuple(to_numpy(std::move(found.row_begin)), to_numpy(std::move(found.column)),
                    to_numpy(std::move(found.distance)), std::move(answered));
}

auto nearest(const HeldSurface& held, const PointArrays& set, const PointArrays& queries, std::size_t count,
             int method, nb::object progress) {
  auto [found, answered] = ask(method, progress, [&](const TaskOptions& options) {
    return nearest_of_set(*held.surface, held.points(set), held.points(queries), count, options);
  });
  return std::tuple(to_numpy(std::move(found.position)), to_numpy(std::move(found.distance)),
                    std::move(answered));
}

// ---- Regions, samplings, lines and measures

/// Vertices, faces and weights of points.
PointRows rows_of_points(const HeldSurface& held, const std::vector<SurfacePoint>& points) {
  PointColumns columns;
  for (const SurfacePoint& point : points) columns.add(held.mesh(), point);
  return columns.take();
}

/// Regions and distances of vertices, regions of faces, areas, points and edges of borders, their regions.
auto voronoi(const HeldSurface& held, const PointArrays& points, int method, nb::object progress) {
  auto [found, answered] = ask(method, progress, [&](const TaskOptions& options) {
    return voronoi_regions(*held.surface, held.points(points), options);
  });
  return std::tuple(of_given_vertices(held.mesh(), std::move(found.vertex_region)),
                    of_given_vertices(held.mesh(), std::move(found.distance)),
                    by_input_face(held.held_mesh, found.face_region), to_numpy(std::move(found.area)),
                    to_numpy(std::move(found.borders.points)), to_numpy(std::move(found.borders.segments)),
                    to_numpy(std::move(found.border_regions)), std::move(answered));
}

/// Points, edges, and the level at each point.
auto isolines_of(const HeldSurface& held, const ValueArray& field, const ValueArray& levels,
                 int interpolation) {
  Isolines found;
  {
    nb::gil_scoped_release release;
    found =
        isolines(held.mesh(), values_of(field), values_of(levels), static_cast<Interpolation>(interpolation));
  }
  return std::tuple(to_numpy(std::move(found.lines.points)), to_numpy(std::move(found.lines.segments)),
                    to_numpy(std::move(found.level_of_point)));
}

auto farthest(const HeldSurface& held, Index count, double radius, const PointArrays& start,
              std::uint64_t seed, int method, nb::object progress) {
  auto [found, answered] = ask(method, progress, [&](const TaskOptions& options) {
    return sample_farthest(*held.surface, {count, radius}, held.points(start), seed, options);
  });
  return std::tuple(rows_of_points(held, found.points), to_numpy(std::move(found.radius)),
                    to_numpy(std::move(found.distance)), found.covering_radius, std::move(answered));
}

auto poisson_disk(const HeldSurface& held, double radius, std::uint64_t seed, int method,
                  nb::object progress) {
  auto [found, answered] = ask(method, progress, [&](const TaskOptions& options) {
    return sample_poisson_disk(*held.surface, radius, seed, options);
  });
  return std::tuple(to_numpy(std::move(found)), std::move(answered));
}

auto disk(const HeldSurface& held, const PointArrays& sources, double radius, int method,
          nb::object progress) {
  auto [found, answered] = ask(method, progress, [&](const TaskOptions& options) {
    return geodesic_disk(*held.surface, held.points(sources), radius, options);
  });
  for (Index& face : found.faces) face = held.mesh().input_face(face);
  return std::tuple(to_numpy(std::move(found.vertices)), to_numpy(std::move(found.distance)),
                    to_numpy(std::move(found.faces)), std::move(answered));
}

auto eccentricity(const HeldSurface& held, const PointArrays& points, int method, nb::object progress) {
  auto [found, answered] = ask(method, progress, [&](const TaskOptions& options) {
    return eccentricities(*held.surface, held.points(points), options);
  });
  std::vector<double> distance;
  std::vector<Index> vertex;
  for (const Eccentricity& one : found) {
    distance.push_back(one.distance);
    vertex.push_back(one.farthest);
  }
  return std::tuple(to_numpy(std::move(distance)), to_numpy(std::move(vertex)), std::move(answered));
}

/// `start`: no_index for the largest component.
auto extent(const HeldSurface& held, Index start, Index max_fields, int method, nb::object progress) {
  auto [found, answered] = ask(method, progress, [&](const TaskOptions& options) {
    const Index first = start == no_index ? largest_component(held.mesh()).first_vertex : start;
    return extent_of_component(*held.surface, first, max_fields, options);
  });
  return std::tuple(
      std::pair(found.diameter.lower, found.diameter.upper), std::pair(found.ends[0], found.ends[1]),
      std::pair(found.radius.lower, found.radius.upper), found.centre, found.fields, std::move(answered));
}

auto relax(const HeldSurface& held, const PointArrays& points, Index rounds, int method,
           nb::object progress) {
  auto [found, answered] = ask(method, progress, [&](const TaskOptions& options) {
    return relax_points(*held.surface, held.points(points), rounds, options);
  });
  return std::tuple(rows_of_points(held, found.points), to_numpy(std::move(found.energy)),
                    std::move(answered));
}

/// The functions that write to an array, for arrays of one type.
template <class Entry>
void bind_fills(nb::class_<HeldSurface>& surface) {
  const nb::arg method("method");
  const auto out = nb::arg("out").noconvert();
  const auto progress = nb::arg("progress").none();
  surface
      .def("fill_matrix", &fill_matrix<Entry>, nb::arg("rows"), nb::arg("columns").none(), nb::arg("entries"),
           out, method, progress)
      .def("fill_fields", &fill_fields<Entry>, nb::arg("sources"), nb::arg("max_distance"), out, method,
           progress);
}

}  // namespace

void bind_tasks(nb::class_<HeldSurface>& surface) {
  const nb::arg points("points"), radius("radius"), seed("seed"), method("method");
  const auto progress = nb::arg("progress").none();
  bind_fills<double>(surface);
  bind_fills<float>(surface);
  surface
      .def("pairs_within", &within, points, nb::arg("others").none(), radius, nb::arg("max_bytes"), method,
           progress)
      .def("nearest", &nearest, nb::arg("set"), nb::arg("queries"), nb::arg("count"), method, progress)
      .def("voronoi", &voronoi, points, method, progress)
      .def("isolines", &isolines_of, nb::arg("field"), nb::arg("levels"), nb::arg("interpolation"))
      .def("sample_farthest", &farthest, nb::arg("count"), radius, nb::arg("start"), seed, method, progress)
      .def("sample_poisson_disk", &poisson_disk, radius, seed, method, progress)
      .def("disk", &disk, nb::arg("sources"), radius, method, progress)
      .def("eccentricity", &eccentricity, points, method, progress)
      .def("extent", &extent, nb::arg("start"), nb::arg("max_fields"), method, progress)
      .def("relax", &relax, points, nb::arg("rounds"), method, progress);
}

// ---- The class _core.OutputFile: a file that Python maps and that replaces its target when complete

namespace {

/// Creates the file: `head`, followed by `size` bytes of space.
OutputFile* make(const std::filesystem::path& file, const std::string& what, const nb::bytes& head,
                 std::uint64_t size) {
  nb::gil_scoped_release release;
  auto out = std::make_unique<OutputFile>(file, what);
  out->reserve(head.size() + size);
  out->write(std::as_bytes(std::span(head.c_str(), head.size())));
  return out.release();
}

}  // namespace

void bind_output(nb::module_& module) {
  module.def("available_memory_bytes", &available_memory_bytes);
  nb::class_<OutputFile>(module, "OutputFile")
      .def_static("make", &make, nb::arg("file"), nb::arg("what"), nb::arg("head"), nb::arg("size"))
      .def_prop_ro("temporary", &OutputFile::temporary)
      .def("finish", &OutputFile::finish, nb::call_guard<nb::gil_scoped_release>())
      .def("discard", &OutputFile::discard);
}

}  // namespace vorogeo::python
