// A mesh cut along lines over it: faces divided, each part with its region, and points that say where they
// were.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/gaps.h"
#include "mesh/mesh.h"
#include "mesh/surface_point.h"
#include "support/progress.h"
#include "tasks/surface_lines.h"

namespace vorogeo {

/// An edge by its ends, as sides of faces have them.
inline std::array<Index, 2> edge_of(Index a, Index b) { return a < b ? std::array{a, b} : std::array{b, a}; }

/// The mesh after a cut. Parts of neighbouring faces share the points of the lines, so it is as watertight as
/// it was.
struct CutMesh {
  /// By vertex, its place on the mesh that was cut; the vertices of that mesh come first.
  std::vector<SurfacePoint> points;
  std::vector<std::array<Index, 3>> faces;  ///< in the order of the faces that they are parts of; no bridges
  std::vector<Index> face_of;               ///< by face: the face of the original mesh that it is a part of
  std::vector<Index> region;                ///< by face
  /// Along the lines, in their direction; each once.
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::vector<Index>> lines;  ///< by line given, the points that it passes
  std::vector<SideOfFace> sides;          ///< of all faces, sorted; only from cut_along()
  /// By face: 1 to the left of a line, as most faces are turned, -1 to its right, 0 beside none or both.
  std::vector<Index> side;
};

/// Cuts along the lines on which a field has one of the levels (isolines); greater values lie to their left.
/// The region of a face is the number of different levels that are at most its values; no_index where these
/// are not finite. \throw InvalidInput and NotEnoughMemory as isolines(); Cancelled.
CutMesh cut_at_levels(const Mesh& mesh, std::span<const double> values, std::span<const double> levels,
                      Interpolation interpolation, const Progress& progress = {});

/// Cuts along polylines such as paths: straight from each point to the next, in a face that both share. The
/// region of a face is its connected part after the cut, numbered in the order of the faces. Lines may cross
/// and touch. \throw InvalidInput for a point that is not on the mesh, and where two share no face or only
/// one over a gap; Cancelled.
CutMesh cut_along(const Mesh& mesh, const std::vector<std::vector<SurfacePoint>>& lines,
                  const Progress& progress = {});

}  // namespace vorogeo
