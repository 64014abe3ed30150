// Meshes some of whose edges have negligible length, or are doubled at the same place.
#pragma once

#include "support/shapes.h"

namespace vorogeo::test {

/// A part of the edges, none of which share a vertex, scaled about their first end: to length 0 by factor 0
/// (two vertices at the same place), to twice their length by 2.
Soup with_scaled_edges(const Soup& soup, double part, double factor, unsigned seed);

/// A part of the inner edges, none of which share a face, cut open: each is given two midpoints at the same
/// place, one for the face on either side, so that the surface has a slit there. The new vertices come last,
/// in pairs; the faces are renumbered.
Soup with_slit_edges(const Soup& soup, double part, unsigned seed);

}  // namespace vorogeo::test
