// Tasks on an index: matrices, regions, samplings, lines; files of results.
#include "tasks_binding.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include <span>

#include "arrays.h"
#include "support/file.h"
#include "support/memory.h"
#include "tasks/distance_matrix.h"
#include "tasks/neighbors.h"

namespace vorogeo::python {

// ---- The functions of _core that fill matrices and find neighbours

namespace {

/// Memory of the caller, such as an array or a mapped file, in double or single precision.
template <class Entry>
using OutArray = nb::ndarray<Entry, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

template <class Entry>
std::span<Entry> values_of(const OutArray<Entry>& out) {
  return {out.data(), out.shape(0) * out.shape(1)};
}

template <class Entry>
void fill_matrix(nb::handle index, const PointArrays& rows, const PointArrays& columns, int method,
                 bool exact, const OutArray<Entry>& out, nb::object progress) {
  with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    distance_matrix(team, points_from(team.mesh(), rows), points_from(team.mesh(), columns),
                    static_cast<MatrixMethod>(method), values_of(out), report);
  });
}

template <class Entry>
void fill_square_matrix(nb::handle index, const PointArrays& points, int method, bool exact,
                        const OutArray<Entry>& out, nb::object progress) {
  with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    distance_matrix(team, points_from(team.mesh(), points), static_cast<MatrixMethod>(method), values_of(out),
                    report);
  });
}

template <class Entry>
void fill_fields(nb::handle index, const PointArrays& sources, double max_distance, bool exact,
                 const OutArray<Entry>& out, nb::object progress) {
  with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    distance_fields(team, points_from(team.mesh(), sources), max_distance, values_of(out), report);
  });
}

/// The functions that write to an array, for arrays of one type.
template <class Entry>
void bind_fills(nb::module_& module) {
  const nb::arg index("index"), method("method"), exact("exact");
  const auto out = nb::arg("out").noconvert();
  const auto progress = nb::arg("progress").none();
  module.def("fill_matrix", &fill_matrix<Entry>, index, nb::arg("rows"), nb::arg("columns"), method, exact,
             out, progress);
  module.def("fill_square_matrix", &fill_square_matrix<Entry>, index, nb::arg("points"), method, exact, out,
             progress);
  module.def("fill_fields", &fill_fields<Entry>, index, nb::arg("sources"), nb::arg("max_distance"), exact,
             out, progress);
}

DoubleArray pairs(nb::handle index, const PointArrays& sources, const PointArrays& targets,
                  nb::object progress) {
  std::vector<double> values(sources.vertex.shape(0));
  with_team(index, progress, [&](FieldTeam& team, const Progress& report) {
    pair_distances(team, points_from(team.mesh(), sources), points_from(team.mesh(), targets), values,
                   report);
  });
  return to_numpy(std::move(values));
}

nb::tuple as_tuple(SparseDistances&& sparse) {
  return nb::make_tuple(to_numpy(std::move(sparse.row_begin)), to_numpy(std::move(sparse.column)),
                        to_numpy(std::move(sparse.distance)));
}

nb::tuple within(nb::handle index, const PointArrays& points, double radius, bool exact,
                 std::int64_t max_bytes, nb::object progress) {
  return as_tuple(with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    return pairs_within(team, points_from(team.mesh(), points), radius, max_bytes, report);
  }));
}

nb::tuple within_others(nb::handle index, const PointArrays& points, const PointArrays& others, double radius,
                        bool exact, std::int64_t max_bytes, nb::object progress) {
  return as_tuple(with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    return pairs_within(team, points_from(team.mesh(), points), points_from(team.mesh(), others), radius,
                        max_bytes, report);
  }));
}

nb::tuple nearest(nb::handle index, const PointArrays& set, const PointArrays& queries, std::size_t count,
                  bool exact, nb::object progress) {
  NearestOfSet found = with_team(index, exact, progress, [&](FieldTeam& team, const Progress& report) {
    return nearest_of_set(team, points_from(team.mesh(), set), points_from(team.mesh(), queries), count,
                          report);
  });
  return nb::make_tuple(to_numpy(std::move(found.position)), to_numpy(std::move(found.distance)));
}

}  // namespace

void bind_tasks(nb::module_& module) {
  const nb::arg index("index"), points("points"), others("others"), sources("sources"), radius("radius"),
      exact("exact"), max_bytes("max_bytes");
  const auto progress = nb::arg("progress").none();
  module.def("available_memory_bytes", &available_memory_bytes);
  bind_fills<double>(module);
  bind_fills<float>(module);
  module.def("pair_distances", &pairs, index, sources, nb::arg("targets"), progress);
  module.def("pairs_within", &within, index, points, radius, exact, max_bytes, progress);
  module.def("pairs_within_others", &within_others, index, points, others, radius, exact, max_bytes,
             progress);
  module.def("nearest", &nearest, index, nb::arg("set"), nb::arg("queries"), nb::arg("count"), exact,
             progress);
}

// ---- The class _core.OutputFile: a file that Python maps and that replaces its target when complete
// is complete

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
