// The class _core.OutputFile: a file that Python maps into memory and that replaces its target once it is
// complete.
#include "output_binding.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include <span>

#include "support/file.h"

namespace vorogeo::python {

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
