// Splits faces on which a metric varies so much that one side is longer than the two others together.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// A metric on the edges of a mesh to which vertices can be added.
struct LengthsAlongLines {
  /// The length of the line between two vertices, the smaller number first.
  std::function<double(Index, Index)> length;
  /// Adds the vertex in the middle of a line, with the metric interpolated there.
  std::function<void(Index, Index)> add_middle;
};

/// Whether the longest side of a face is longer than the two others together by more than `slack`, a
/// fraction.
bool breaks_triangle(const std::array<double, 3>& sides, double slack);

/// Splits each face that breaks the triangle inequality in the middle of its longest side, with the other
/// faces at that side, and so on for their parts: the smaller the parts, the less the metric varies on them.
/// Faces without width in space, and the last of many parts of a face, stay as they are.
///
/// \param split_faces Becomes the number of faces that break the inequality and are split.
/// \return empty if there are none. Complexity: linear in the faces, if few have to be split.
FaceSplits split_faces_for(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                           const SideLengths& sides, const LengthsAlongLines& lines, Index& split_faces);

}  // namespace vorogeo
