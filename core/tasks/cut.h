// A mesh cut along lines over it: faces divided, each part with its region, and points that say where they
// were.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_point.h"
#include "tasks/surface_lines.h"

namespace vorogeo {

/// The mesh after a cut. Parts of neighbouring faces share the points of the lines, so it is as watertight as
/// it was.
struct CutMesh {
  /// Of the mesh that was cut, by vertex: first its own vertices.
  std::vector<SurfacePoint> points;
  std::vector<std::array<Index, 3>> faces;  ///< in the order of those that they are parts of; no bridges
  std::vector<Index> face_of;               ///< by face: the one that it is a part of
  std::vector<Index> region;                ///< by face
  /// Along the lines, in their direction; each once.
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::vector<Index>> lines;  ///< by line given, the points that it passes
  std::vector<Index> side;  ///< by face, as it is turned: 1 left of a line, -1 right, 0 beside none or both
};

/// A side of a face by its ends, the smaller first.
struct FaceSide {
  std::pair<Index, Index> ends;
  Index face;
};
/// All sides of all faces, those with the same ends one after another.
std::vector<FaceSide> sorted_sides(const CutMesh& cut);

/// Along the lines on which a field has one of the levels (isolines), which have greater values to their
/// left. The region of a face is the number of different levels that are at most its values; no_index where
/// these are not finite. \throw InvalidInput as isolines().
CutMesh cut_at_levels(const Mesh& mesh, std::span<const double> values, std::span<const double> levels,
                      Interpolation interpolation);

/// Along lines of points, straight from each to the next in a face that both share, such as paths. The region
/// of a face is its connected part after the cut, numbered in the order of the faces. Lines may cross and
/// touch. \throw InvalidInput for a point that is not on the mesh, and where two share no face or only one
/// over a gap.
CutMesh cut_along(const Mesh& mesh, const std::vector<std::vector<SurfacePoint>>& lines);

}  // namespace vorogeo
