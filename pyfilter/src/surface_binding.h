// The class _core.Surface: a surface with its queries, without argument checks.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>

#include "mesh_binding.h"
#include "progress_bridge.h"
#include "tasks/workers.h"

namespace vorogeo::python {

/// What a Python object of the class holds; several objects may hold one surface.
struct HeldSurface {
  std::shared_ptr<Surface> surface;
  std::shared_ptr<MeshPoints> points;
  std::size_t input_faces;  ///< rows of the faces that were given

  const Mesh& mesh() const { return *surface->mesh(); }
};

/// What answered, for Python: by, seconds, index_seconds, remark.
nb::tuple about(const Answered& answered);

/// Calls body(surface, options) without the GIL; `answered` receives what answered.
template <class Body>
auto run_task(const HeldSurface& held, int method, nb::handle progress, Answered& answered, Body&& body) {
  ProgressBridge bridge(progress);
  return bridge.run([&](const Progress& report) {
    const TaskOptions options{static_cast<AnswerMethod>(method), report, &answered};
    return body(*held.surface, options);
  });
}

void bind_surface(nanobind::module_& module);

}  // namespace vorogeo::python
