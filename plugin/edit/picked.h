// A point that was picked on the screen.
#pragma once

#include "mesh/mesh.h"

namespace vorogeo::plugin {

/// A position in the coordinates of the layer, and how far from the surface it may lie: what a pixel and the
/// depth of the picture resolve. Farther away, something else was picked.
struct Picked {
  Point at{};
  double tolerance = 0.0;
};

}  // namespace vorogeo::plugin
