// Surfaces, and the tasks on them.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>

#include "mesh_binding.h"
#include "query/surface.h"

namespace vorogeo::python {

/// What a Python object of the class holds.
struct HeldSurface {
  std::shared_ptr<Surface> surface;
  std::shared_ptr<MeshPoints> points;
  int threads;              ///< 0: one per core
  std::size_t input_faces;  ///< rows of the faces that were given
};

void bind_surface(nanobind::module_& module);

}  // namespace vorogeo::python
