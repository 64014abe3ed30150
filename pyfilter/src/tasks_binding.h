// The functions of _core for many queries at once, without argument checks.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

/// Matrices and neighbours; each takes an object of _core.Index.
void bind_tasks(nanobind::module_& module);
/// What is built on distance fields: Voronoi regions, samplings, isolines, disks, extents, relaxation.
void bind_surface_tasks(nanobind::module_& module);

}  // namespace vorogeo::python
