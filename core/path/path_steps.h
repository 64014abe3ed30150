// A strip of faces along a chain of border vertices, by the distances that the tables of the patches hold.
#pragma once

#include "path/path_chain.h"
#include "path/path_strip.h"

namespace vorogeo {

/// Follows every step of the chain through its patch: from one end towards the other, which is a border
/// vertex, down the distances of that vertex. In each face the distances of two vertices place the goal in
/// the plane of the face; the straight line towards it leads on. `strip` has its end points (work mesh) set;
/// its faces are filled in. \return false if a table does not lead to the end of its step. Complexity:
/// O(faces).
bool strip_along_chain(const IndexData& data, const PathChain& chain, FaceStrip& strip);

}  // namespace vorogeo
