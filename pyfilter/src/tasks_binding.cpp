// Tasks on a surface: matrices, regions, samplings, lines; files of results.
#include "tasks_binding.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include <span>

#include "arrays.h"
#include "mesh/outliers.h"
#include "support/file.h"
#include "support/memory.h"
#include "surface_binding.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/neighbors.h"
#include "tasks/spread_points.h"
#include "tasks/surface_lines.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo::python {

// ---- Matrices and neighbours

namespace {

/// Memory of the caller, such as an array or a mapped file, in double or single precision.
template <class Entry>
using OutArray = nb::ndarray<Entry, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

template <class Entry>
std::span<Entry> values_of(const OutArray<Entry>& out) {
  return {out.data(), out.shape(0) * out.shape(1)};
}

template <class Entry>
nb::tuple fill_matrix(const HeldSurface& held, const PointArrays& rows, const PointArrays& columns,
                      int entries, int method, const OutArray<Entry>& out, nb::object progress) {
  Answered answered;
  run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
    distance_matrix(surface, points_from(held.mesh(), rows), points_from(held.mesh(), columns),
                    static_cast<MatrixMethod>(entries), values_of(out), options);
  });
  return about(answered);
}

template <class Entry>
nb::tuple fill_square_matrix(const HeldSurface& held, const PointArrays& points, int entries, int method,
                             const OutArray<Entry>& out, nb::object progress) {
  Answered answered;
  run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
    distance_matrix(surface, points_from(held.mesh(), points), static_cast<MatrixMethod>(entries),
                    values_of(out), options);
  });
  return about(answered);
}

template <class Entry>
nb::tuple fill_fields(const HeldSurface& held, const PointArrays& sources, double max_distance, int method,
                      const OutArray<Entry>& out, nb::object progress) {
  Answered answered;
  run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
    distance_fields(surface, points_from(held.mesh(), sources), max_distance, values_of(out), options);
  });
  return about(answered);
}

/// The functions that write to an array, for arrays of one type.
template <class Entry>
void bind_fills(nb::module_& module) {
  const nb::arg surface("surface"), entries("entries"), method("method");
  const auto out = nb::arg("out").noconvert();
  const auto progress = nb::arg("progress").none();
  module.def("fill_matrix", &fill_matrix<Entry>, surface, nb::arg("rows"), nb::arg("columns"), entries,
             method, out, progress);
  module.def("fill_square_matrix", &fill_square_matrix<Entry>, surface, nb::arg("points"), entries, method,
             out, progress);
  module.def("fill_fields", &fill_fields<Entry>, surface, nb::arg("sources"), nb::arg("max_distance"), method,
             out, progress);
}

nb::tuple as_tuple(SparseDistances&& sparse, const Answered& answered) {
  return nb::make_tuple(to_numpy(std::move(sparse.row_begin)), to_numpy(std::move(sparse.column)),
                        to_numpy(std::move(sparse.distance)), about(answered));
}

nb::tuple within(const HeldSurface& held, const PointArrays& points, double radius, int method,
                 std::int64_t max_bytes, nb::object progress) {
  Answered answered;
  auto found = run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
    return pairs_within(surface, points_from(held.mesh(), points), radius, max_bytes, options);
  });
  return as_tuple(std::move(found), answered);
}

nb::tuple within_others(const HeldSurface& held, const PointArrays& points, const PointArrays& others,
                        double radius, int method, std::int64_t max_bytes, nb::object progress) {
  Answered answered;
  auto found = run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
    return pairs_within(surface, points_from(held.mesh(), points), points_from(held.mesh(), others), radius,
                        max_bytes, options);
  });
  return as_tuple(std::move(found), answered);
}

nb::tuple nearest(const HeldSurface& held, const PointArrays& set, const PointArrays& queries,
                  std::size_t count, int method, nb::object progress) {
  Answered answered;
  NearestOfSet found =
      run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
        return nearest_of_set(surface, points_from(held.mesh(), set), points_from(held.mesh(), queries),
                              count, options);
      });
  return nb::make_tuple(to_numpy(std::move(found.position)), to_numpy(std::move(found.distance)),
                        about(answered));
}

// ---- Regions, samplings, lines and measures

using FieldArray = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

std::span<const double> values_of(const FieldArray& values) { return {values.data(), values.shape(0)}; }

/// Values at the centres of faces, by row of the faces given; no_index for a face that was left out.
IndexArray by_input_face(const HeldSurface& held, const std::vector<Index>& of_face) {
  std::vector<Index> values(held.input_faces, no_index);
  const Mesh& mesh = held.mesh();
  for (Index f : central_parts(mesh)) values[mesh.input_face(f)] = of_face[f];
  return to_numpy(std::move(values));
}

/// Vertices, faces and weights of points.
nb::tuple rows_of(const HeldSurface& held, const std::vector<SurfacePoint>& points) {
  PointRows rows;
  for (const SurfacePoint& point : points) rows.add(held.mesh(), point);
  return nb::make_tuple(to_numpy(std::move(rows.vertex)), to_numpy(std::move(rows.face)),
                        to_numpy(std::move(rows.weights)));
}

nb::tuple voronoi(const HeldSurface& held, const PointArrays& points, int method, nb::object progress) {
  Answered answered;
  VoronoiRegions found =
      run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
        return voronoi_regions(surface, points_from(held.mesh(), points), options);
      });
  return nb::make_tuple(of_given_vertices(held.mesh(), std::move(found.vertex_region)),
                        of_given_vertices(held.mesh(), std::move(found.distance)),
                        by_input_face(held, found.face_region), to_numpy(std::move(found.area)),
                        flattened(found.borders.points), flattened(found.borders.segments),
                        flattened(found.border_regions), about(answered));
}

nb::tuple iso(const HeldSurface& held, const FieldArray& field, const FieldArray& levels, int interpolation) {
  Isolines found;
  {
    nb::gil_scoped_release release;
    found =
        isolines(held.mesh(), values_of(field), values_of(levels), static_cast<Interpolation>(interpolation));
  }
  return nb::make_tuple(flattened(found.lines.points), flattened(found.lines.segments),
                        to_numpy(std::move(found.level_of_point)));
}

nb::tuple farthest(const HeldSurface& held, Index count, double radius, const PointArrays& start,
                   std::uint64_t seed, int method, nb::object progress) {
  Answered answered;
  FarthestSamples found =
      run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
        return sample_farthest(surface, {count, radius}, points_from(held.mesh(), start), seed, options);
      });
  return nb::make_tuple(rows_of(held, found.points), to_numpy(std::move(found.radius)),
                        to_numpy(std::move(found.distance)), found.covering_radius, about(answered));
}

nb::tuple poisson_disk(const HeldSurface& held, double radius, std::uint64_t seed, int method,
                       nb::object progress) {
  Answered answered;
  auto found = run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
    return sample_poisson_disk(surface, radius, seed, options);
  });
  return nb::make_tuple(to_numpy(std::move(found)), about(answered));
}

nb::tuple disk(const HeldSurface& held, const PointArrays& sources, double radius, int method) {
  Answered answered;
  GeodesicDisk found =
      run_task(held, method, nb::none(), answered, [&](Surface& surface, const TaskOptions& options) {
        return geodesic_disk(surface, points_from(held.mesh(), sources), radius, options);
      });
  for (Index& face : found.faces) face = held.mesh().input_face(face);
  return nb::make_tuple(to_numpy(std::move(found.vertices)), to_numpy(std::move(found.distance)),
                        to_numpy(std::move(found.faces)), about(answered));
}

nb::tuple eccentricity(const HeldSurface& held, const PointArrays& points, int method, nb::object progress) {
  Answered answered;
  const auto found =
      run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
        return eccentricities(surface, points_from(held.mesh(), points), options);
      });
  std::vector<double> distance;
  std::vector<Index> vertex;
  for (const Eccentricity& one : found) {
    distance.push_back(one.distance);
    vertex.push_back(one.farthest);
  }
  return nb::make_tuple(to_numpy(std::move(distance)), to_numpy(std::move(vertex)), about(answered));
}

/// `start`: no_index for the largest component.
nb::tuple extent(const HeldSurface& held, Index start, Index max_fields, int method, nb::object progress) {
  Answered answered;
  const Extent found =
      run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
        const Index first = start == no_index ? largest_component(held.mesh()).first_vertex : start;
        return extent_of_component(surface, first, max_fields, options);
      });
  return nb::make_tuple(nb::make_tuple(found.diameter.lower, found.diameter.upper),
                        nb::make_tuple(found.ends[0], found.ends[1]),
                        nb::make_tuple(found.radius.lower, found.radius.upper), found.centre, found.fields,
                        about(answered));
}

nb::tuple relax(const HeldSurface& held, const PointArrays& points, Index rounds, int method,
                nb::object progress) {
  Answered answered;
  RelaxedPoints found =
      run_task(held, method, progress, answered, [&](Surface& surface, const TaskOptions& options) {
        return relax_points(surface, points_from(held.mesh(), points), rounds, options);
      });
  return nb::make_tuple(rows_of(held, found.points), to_numpy(std::move(found.energy)), about(answered));
}

}  // namespace

void bind_tasks(nb::module_& module) {
  const nb::arg surface("surface"), points("points"), others("others"), sources("sources"), radius("radius"),
      seed("seed"), method("method"), max_bytes("max_bytes");
  const auto progress = nb::arg("progress").none();
  module.def("available_memory_bytes", &available_memory_bytes);
  bind_fills<double>(module);
  bind_fills<float>(module);
  module.def("pairs_within", &within, surface, points, radius, method, max_bytes, progress);
  module.def("pairs_within_others", &within_others, surface, points, others, radius, method, max_bytes,
             progress);
  module.def("nearest", &nearest, surface, nb::arg("set"), nb::arg("queries"), nb::arg("count"), method,
             progress);
  module.def("voronoi", &voronoi, surface, points, method, progress);
  module.def("isolines", &iso, surface, nb::arg("field"), nb::arg("levels"), nb::arg("interpolation"));
  module.def("sample_farthest", &farthest, surface, nb::arg("count"), radius, nb::arg("start"), seed, method,
             progress);
  module.def("sample_poisson_disk", &poisson_disk, surface, radius, seed, method, progress);
  module.def("disk", &disk, surface, sources, radius, method);
  module.def("eccentricity", &eccentricity, surface, points, method, progress);
  module.def("extent", &extent, surface, nb::arg("start"), nb::arg("max_fields"), method, progress);
  module.def("relax", &relax, surface, points, nb::arg("rounds"), method, progress);
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
  nb::class_<OutputFile>(module, "OutputFile")
      .def_static("make", &make, nb::arg("file"), nb::arg("what"), nb::arg("head"), nb::arg("size"))
      .def_prop_ro("temporary", &OutputFile::temporary)
      .def("finish", &OutputFile::finish, nb::call_guard<nb::gil_scoped_release>())
      .def("discard", &OutputFile::discard);
}

}  // namespace vorogeo::python
