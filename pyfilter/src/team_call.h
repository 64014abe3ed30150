// Runs a task of the core that asks for many fields.
#pragma once

#include "index_binding.h"
#include "progress_bridge.h"
#include "surface_binding.h"
#include "tasks/field_team.h"

namespace vorogeo::python {

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

}  // namespace vorogeo::python
