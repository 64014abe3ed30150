// How questions are answered, and results that hold numbers only, no points of a surface and no paths: they
// are the same inside the library. The functions that return them are in vorogeo.h, which includes this.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace vorogeo {
inline namespace v0 {

/// How a question is answered.
enum class Answer : std::uint8_t {
  automatic,  ///< by what costs least: questions that reach a small part of the surface exactly; all others
              ///< by the index if there is one, otherwise exactly until an index has become worth its build;
              ///< but fields of more than two million vertices are quick without an index
  index,      ///< by the index, which is built if there is none
  exact,      ///< by exact propagation over the faces
  quick  ///< fields only: below a tenth of a percent off in the mean, on large meshes in a third to a tenth
         ///< of the time
};

/// A sparse matrix in compressed rows: row i holds the entries row_begin[i] to row_begin[i + 1].
struct SparseDistances {
  std::vector<std::int64_t> row_begin;
  std::vector<int> column;  ///< ascending within a row
  std::vector<double> distance;
};

/// For each query, the positions in the set of the `count` nearest points, nearest first (of equally near
/// ones, the smaller position first), and their distances; -1 and `unreachable` where fewer can be reached.
struct NearestOfSet {
  std::vector<int> position;
  std::vector<double> distance;
};

/// By point of a path, in space except for the length. Normals are those of most faces, also where some are
/// flipped.
struct Profile {
  std::vector<double> along;   ///< length of the path up to the point
  std::vector<double> height;  ///< of the point in the direction `up`
  /// Angle between the normal and `up`, in radians: 0 on level ground that faces up, pi/2 on a wall.
  std::vector<double> angle;
  /// Curvature of the surface in the direction of the path: 1/r along a great circle of a sphere whose
  /// normals point outwards, negative in hollows. It is how much the normals tilt forwards over the steps
  /// beside the point; these are interpolated between those of the vertices, and as rough.
  std::vector<double> curvature;
  std::vector<double> thickness;  ///< from the point against the normal to the next face; `unreachable`: none
};

/// Polylines on a surface: each segment joins two of the points, and segments of one line share points.
struct SurfaceLines {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 2>> segments;
};

/// Geodesic Voronoi regions: positions in the list of sites, -1 where none can be reached.
struct VoronoiRegions {
  std::vector<int> vertex_region;  ///< of the nearest site; of equally near ones, the first
  std::vector<double> distance;    ///< of each vertex from its site
  std::vector<int> face_region;    ///< at the centre of each face
  std::vector<double> area;        ///< of each region, in the square of the mesh's unit
  SurfaceLines borders;
  std::vector<std::array<int, 2>> border_regions;  ///< beside each segment, the smaller one first
};

/// What lies within a radius of the nearest of some sources.
struct Disk {
  std::vector<int> vertices;     ///< ascending
  std::vector<double> distance;  ///< of each
  std::vector<int> faces;        ///< with all corners inside, ascending
};

/// What lies within a distance of the nearest of some sources, faces at its border in part.
struct Band {
  double area = 0.0;           ///< in the square of the mesh's unit; that over a gap does not count
  double border_length = 0.0;  ///< of the line at the distance, without borders of the mesh
};

/// What a region measures, in the metric of the surface.
struct RegionArea {
  double area = 0.0;           ///< that over a gap does not count
  double border_length = 0.0;  ///< where faces are inside on one side only; borders of the surface count
  /// Volume that the region encloses in space, if each of its edges has two of its faces; otherwise NaN.
  /// Cavities, whose faces are turned inwards, do not count.
  double volume = std::numeric_limits<double>::quiet_NaN();
};

/// How far two sets of points are from each other.
struct SetDistances {
  std::vector<double> to_second;  ///< by point of the first set, from the nearest of the second
  std::vector<double> to_first;   ///< the other way
  double nearest = 0.0;           ///< the least of them
  double mean = 0.0;              ///< of the means of both
  double hausdorff = 0.0;         ///< the greatest of them
};

/// The vertex farthest from a point, within its component (of equally far ones, the first), and its distance.
struct Eccentricity {
  double distance = 0.0;
  int farthest = -1;
};

/// Derivatives of the distances of pairs by the positions of vertices. Those that are not listed are 0.
struct DistanceGradient {
  std::vector<double> distance;                 ///< by pair; `unreachable` where no path leads
  std::vector<int> pair;                        ///< by entry, ascending
  std::vector<int> vertex;                      ///< by entry, ascending within a pair
  std::vector<std::array<double, 3>> gradient;  ///< by entry
};

struct TextureCoordinates {
  /// By vertex; the point has (0.5, 0.5). NaN beyond the radius.
  std::vector<std::array<double, 2>> coordinates;
  /// By face, the greatest and the least factor by which the picture is stretched beyond its scale: 1 and 1
  /// where the surface is flat. NaN where a corner has no coordinates or the picture no area.
  std::vector<std::array<double, 2>> stretch;
};

}  // namespace v0
}  // namespace vorogeo
