// Tasks on a surface: matrices, regions, samplings, lines; files of results.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

/// Tasks of many queries, without argument checks. Each takes an object of _core.Surface and the number of a
/// method, and returns last what answered.
void bind_tasks(nanobind::module_& module);

/// Files that the Python package writes.
void bind_output(nanobind::module_& module);

}  // namespace vorogeo::python
