// What the classes of _core hold, how a question is asked without the GIL, and the functions that bind them.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.h"
#include "exact/surface_path.h"
#include "mesh/surface_locator.h"
#include "progress_bridge.h"
#include "query/surface.h"
#include "tasks/workers.h"

namespace vorogeo::python {

/// The class _core.Mesh: the mesh that is measured on. May be used by several threads.
struct PythonMesh {
  /// Made when it is first asked for.
  struct Locator {
    std::once_flag once;
    std::optional<SurfaceLocator> made;
  };

  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<Locator> locator = std::make_shared<Locator>();

  const SurfaceLocator& located() const {
    std::call_once(locator->once, [&] { locator->made.emplace(mesh); });
    return *locator->made;
  }
};

/// The class _core.Surface; several objects may hold one surface.
struct PythonSurface {
  PythonMesh python_mesh;
  std::shared_ptr<Surface> surface;

  const Mesh& mesh() const { return *python_mesh.mesh; }
  PointList points(const PointArrays& arrays) const { return points_from(mesh(), arrays); }
  std::optional<PointList> points(const OptionalPoints& arrays) const {
    return arrays ? std::optional(points(*arrays)) : std::nullopt;
  }
};

/// Points for Python.
inline PointColumns columns_of(const PythonSurface& self, const std::vector<SurfacePoint>& points) {
  PointColumns columns;
  for (const SurfacePoint& point : points) columns.add(self.mesh(), point);
  return columns;
}

/// Paths for Python, collected without the GIL: lengths, whether they are certified, where the points of each
/// path begin, positions, the points on the surface, and whether the step from each leads over a gap.
inline auto paths_of(const PythonSurface& self, const std::vector<ExactPath>& paths) {
  std::vector<double> lengths;
  std::vector<Index> certified, over_gap;
  std::vector<std::int64_t> begin{0};
  std::vector<Point> positions;
  PointColumns columns;
  for (const ExactPath& one : paths) {
    lengths.push_back(one.path.length);
    certified.push_back(one.certified ? 1 : 0);
    for (const SurfacePoint& point : one.path.points) {
      positions.push_back(position_of(self.mesh(), point));
      columns.add(self.mesh(), point);
    }
    for (const bool over : steps_over_gaps(self.mesh(), one.path.points)) over_gap.push_back(over ? 1 : 0);
    begin.push_back(static_cast<std::int64_t>(positions.size()));
  }
  return std::tuple(std::move(lengths), std::move(certified), std::move(begin), std::move(positions),
                    std::move(columns), std::move(over_gap));
}

/// What answered: by, seconds, index_seconds, remark, expected_error, unreached.
using About = std::tuple<std::string, double, double, std::string, double, Index>;

inline About about(const Answered& answered) {
  return {name_of(answered.by), answered.seconds,        answered.index_seconds,
          answered.remark,      answered.expected_error, answered.unreached};
}

/// How an argument of a type is taken: None for a missing optional, and no copy of an array to be filled.
template <class Argument>
inline const auto taken = nb::arg();
template <class Value>
inline const auto taken<const std::optional<Value>&> = nb::arg().none();
template <class Entry>
inline const auto taken<const OutArray<Entry>&> = nb::arg().noconvert();

/// Binds a question, to which Python also passes a method (Answer) and a progress function or None, at the
/// end. `question` runs without the GIL and returns a tuple, to which About is appended.
template <class... Parts, class... Arguments>
void bind_question(nb::class_<PythonSurface>& surface, const char* name,
                   std::tuple<Parts...> (*question)(const TaskOptions&, const PythonSurface&, Arguments...)) {
  auto ask = [question](const PythonSurface& self, Arguments... arguments, int method, nb::object progress) {
    Answered answered;
    ProgressBridge bridge(progress);
    auto found = bridge.run([&](const Progress& report) {
      return question({static_cast<Answer>(method), report, &answered}, self, arguments...);
    });
    const auto tuple = [&](auto&... parts) {
      return std::make_tuple(to_python(std::move(parts))..., about(answered));
    };
    return std::apply(tuple, found);
  };
  surface.def(name, ask, taken<Arguments>..., nb::arg(), nb::arg().none());
}

void bind_mesh(nb::class_<PythonMesh>& mesh, nb::module_& module);
void bind_methods(nb::class_<PythonMesh>& mesh, nb::module_& module);
void bind_surface(nb::class_<PythonMesh>& mesh, nb::class_<PythonSurface>& surface);
void bind_tasks(nb::class_<PythonSurface>& surface);
void bind_output(nb::module_& module);

}  // namespace vorogeo::python
