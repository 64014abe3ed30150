// Tasks on an index: matrices, regions, samplings, lines; files of results.
#pragma once

#include <nanobind/nanobind.h>

#include "index_binding.h"
#include "progress_bridge.h"
#include "surface_binding.h"
#include "tasks/field_team.h"

namespace vorogeo::python {

// ---- Runs a task of the core that asks for many fields

/// Calls body(team, progress) without the GIL; the team answers from an object of _core.Index, or by exact
/// propagation on its mesh or on that of an object of _core.Surface.
template <class Body>
auto with_team(nb::handle index, bool exact, nb::handle progress, Body&& body) {
  ProgressBridge bridge(progress);
  if (HeldSurface* surface = nullptr; nb::try_cast(index, surface)) {
    return bridge.run([&](const Progress& report) {
      FieldTeam team(surface->surface->mesh(), surface->threads);
      return body(team, report);
    });
  }
  const HeldIndex held = held_index(index);
  return bridge.run([&](const Progress& report) {
    FieldTeam team =
        exact ? FieldTeam(held.index->mesh(), held.threads) : FieldTeam(held.index, held.threads);
    return body(team, report);
  });
}

template <class Body>
auto with_team(nb::handle index, nb::handle progress, Body&& body) {
  return with_team(index, false, progress, std::forward<Body>(body));
}

// ---- The functions of _core for many queries at once, without argument checks

/// Matrices and neighbours; each takes an object of _core.Index.
void bind_tasks(nanobind::module_& module);
/// What is built on distance fields: Voronoi regions, samplings, isolines, disks, extents, relaxation.
void bind_surface_tasks(nanobind::module_& module);

// ---- Files that the Python package writes

namespace nb = nanobind;

void bind_output(nb::module_& module);

}  // namespace vorogeo::python
