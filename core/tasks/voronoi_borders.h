// Voronoi regions inside one face: their shares of its area, and the borders between them.
#pragma once

#include <array>
#include <vector>

#include "tasks/surface_lines.h"

namespace vorogeo {

/// A site and the squares of its distances at the corners of a face.
struct FaceSite {
  Index site;
  std::array<double, 3> square;
};

/// The fraction of a face's area, in [0, 1], that is nearest to the site at `mine`: the triangle is cut by
/// one line for each other site. Complexity: O(sites^2).
double share_of_face(const std::vector<FaceSite>& sites, std::size_t mine);

/// Draws the borders between regions, face by face.
class BorderTracer {
 public:
  /// The two regions at each segment are added to `border_regions`, the smaller one first.
  BorderTracer(const Mesh& mesh, std::vector<std::array<Index, 2>>& border_regions)
      : border_regions_(border_regions), mesh_(mesh), builder_(mesh) {}

  void trace(Index face, const std::vector<FaceSite>& sites);
  SurfaceLines take() { return builder_.take(); }

 private:
  /// An end of the line between two regions in a face: at a corner or on an edge.
  struct End {
    std::array<double, 3> at{};
    Index corner = no_index;
    Index edge = no_index;
    double t = 0.0;
  };
  Index point_of(const End& end, std::uint64_t line);
  int find_ends(Index face, const std::array<double, 3>& lead, End* ends) const;
  void trace_pair(Index face, const std::vector<FaceSite>& sites, std::size_t i, std::size_t j);

  std::vector<std::array<Index, 2>>& border_regions_;
  const Mesh& mesh_;
  LineBuilder builder_;
};

}  // namespace vorogeo
