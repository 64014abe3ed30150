// Lengths of edges by costs and tensors, and metrics that follow from the shape.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

void bind_metrics(nanobind::module_& module);

}  // namespace vorogeo::python
