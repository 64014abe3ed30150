// The functions of _core that need no index: exact distances and the mesh check.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>

#include "mesh/mesh.h"

namespace vorogeo::python {

/// The class _core.Surface: a mesh without an index, for exact tasks.
struct HeldMesh {
  std::shared_ptr<const Mesh> mesh;
  int threads;  ///< 0: one per core
};

void bind_mesh_functions(nanobind::module_& module);

}  // namespace vorogeo::python
