// What the classes of _core hold, how a question is asked without Python's lock, and what binds each part.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "arrays.h"
#include "mesh/surface_locator.h"
#include "progress_bridge.h"
#include "query/surface.h"
#include "tasks/workers.h"

namespace vorogeo::python {

/// The class _core.Mesh: the mesh that is measured on. May be used by several threads.
struct HeldMesh {
  /// Made when it is first asked for.
  struct Locator {
    std::once_flag once;
    std::optional<SurfaceLocator> made;
  };

  std::shared_ptr<const Mesh> mesh;
  std::size_t input_faces;  ///< rows of the faces that were given
  std::shared_ptr<Locator> locator = std::make_shared<Locator>();
};

/// The class _core.Surface; several objects may hold one surface.
struct HeldSurface {
  HeldMesh held_mesh;
  std::shared_ptr<Surface> surface;

  const Mesh& mesh() const { return *held_mesh.mesh; }
  PointList points(const PointArrays& arrays) const { return points_from(mesh(), arrays); }
};

/// Values at the centres of faces, by row of the faces given; no_index for a face that was left out.
inline Values<Index> by_input_face(const HeldMesh& held, std::span<const Index> of_face) {
  return to_numpy(InputMap(*held.mesh).of_faces(of_face, held.input_faces));
}

/// What answered: by, seconds, index_seconds, remark.
using About = std::tuple<std::string, double, double, std::string>;

inline About about(const Answered& answered) {
  return {to_string(answered.by), answered.seconds, answered.index_seconds, answered.remark};
}

/// What question(options) returns when called without the GIL, and what answered.
template <class Question>
auto ask(int method, nb::handle progress, Question&& question) {
  Answered answered;
  ProgressBridge bridge(progress);
  auto found = bridge.run([&](const Progress& report) {
    return question(TaskOptions{static_cast<AnswerMethod>(method), report, &answered});
  });
  return std::pair(std::move(found), about(answered));
}

void bind_mesh(nb::class_<HeldMesh>& mesh, nb::module_& module);
void bind_methods(nb::class_<HeldMesh>& mesh, nb::module_& module);
void bind_surface(nb::class_<HeldMesh>& mesh, nb::class_<HeldSurface>& surface);
void bind_tasks(nb::class_<HeldSurface>& surface);
void bind_output(nb::module_& module);

}  // namespace vorogeo::python
