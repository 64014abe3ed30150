// Geodesic Voronoi regions, their borders, and the faces that these divide.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "support/progress.h"
#include "tasks/surface_lines.h"
#include "tasks/workers.h"

namespace vorogeo {

// ---- Voronoi regions inside one face: their shares of its area, and the borders between them

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

// ---- Faces divided into smaller ones, with distances from sites at the corners of these

/// A face and the sites that may own a part of it.
struct ContestedFace {
  Index face;
  std::vector<Index> sites;  ///< ascending
};

/// Where the metric jumps, paths into a dear face come from many of its sides, and distances inside do not
/// follow from the distances of its corners. So the contested faces are divided, and the corners of their
/// parts get distances of their own.
class DividedFaces {
 public:
  /// Parts of each side of a face.
  static constexpr Index per_side = 4;
  static constexpr Index parts_per_face = per_side * per_side;
  /// The part of a face in which its centre is.
  static constexpr Index central_part = 9;

  /// `radius`: no distance above it is asked for. \throw Cancelled.
  DividedFaces(Workers& workers, const PointList& sites, std::vector<ContestedFace> contested, double radius,
               const Progress& progress);

  /// The parts of all contested faces, in space; those of contested face i begin at face i * parts_per_face.
  const Mesh& parts() const { return *parts_; }
  const std::vector<ContestedFace>& contested() const { return contested_; }
  /// The sites known at all three corners of a part.
  std::vector<FaceSite> sites_of(Index part) const;

 private:
  std::vector<ContestedFace> contested_;
  std::shared_ptr<const Mesh> parts_;
  std::vector<std::vector<double>> distance_;  ///< by corner of parts, then by site of its `at_`
  std::vector<std::vector<Index>> at_;         ///< by corner of parts: its sites, ascending
};

// ---- Geodesic Voronoi regions of chosen points: labels, areas, and borders that cross the faces

/// Regions of the sites, by the vertices and faces of the mesh; see InputMap for those given. A site that
/// repeats an earlier one owns nothing.
///
/// In a face, the difference of the squares of two distances is interpolated linearly between the corners,
/// which is exact on flat parts of the surface. A site owns the points at which its square is the least, so
/// borders continue over edges, and three or more regions may meet in a face. Where the metric jumps, the
/// same holds for parts of faces (DividedFaces). A region is found in every face that it reaches into, even
/// if it owns none of the corners. \throw InvalidInput for no site or one that is not on the mesh, Cancelled.
/// Complexity: a field for each site, bounded by the greatest distance of a vertex from its site.
VoronoiRegions voronoi_regions(Surface& surface, const PointList& sites, const TaskOptions& options = {});

}  // namespace vorogeo
