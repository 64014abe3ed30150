// Meshes of which a part is many orders smaller than the rest.
#pragma once

#include "support/shapes.h"

namespace vorogeo::test {

/// The soup and a copy of it, `ratio` times as large and 0.5 higher, that share one vertex in 110: needles
/// join the two.
Soup with_small_copy(const Soup& soup, double ratio);

}  // namespace vorogeo::test
