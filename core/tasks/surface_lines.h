// Lines drawn on the surface, and isolines of fields.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "mesh/mesh.h"
#include "support/progress.h"
#include "vorogeo/results.h"

namespace vorogeo {

// ---- Polylines on a surface as points and segments, assembled face by face

double total_length(const SurfaceLines& lines);

/// The lines that segments make, given in any order and direction, by the numbers along them: open lines from
/// end to end, then closed ones from their least number round to it. `name`: of a number, for errors. \throw
/// InvalidInput if one branches. Complexity: O(n log n).
std::vector<std::vector<Index>> lines_in_order(std::vector<std::array<Index, 2>> segments,
                                               const std::function<std::string(Index)>& name);

/// Collects points under keys that neighbouring faces share, so that lines continue from face to face.
class LineBuilder {
 public:
  /// The mesh must outlive the builder.
  explicit LineBuilder(const Mesh& mesh) : mesh_(mesh) {}

  /// The point of line `line` on an edge, at the fraction `t` in [0, 1] from the edge's first vertex; at an
  /// end of the edge, the point at that vertex. Later calls with the same edge and line return the same
  /// point, whatever their t.
  Index on_edge(Index edge, double t, std::uint64_t line);
  Index at_vertex(Index vertex, std::uint64_t line);
  /// A point inside a face; `corner`, a hash of the lines that meet there, distinguishes several in one face.
  Index in_face(Index face, const std::array<double, 3>& barycentric, std::uint64_t corner);
  /// Adds a segment. \return false, with nothing added, if it has no length or exists already.
  bool add_segment(Index a, Index b);

  SurfaceLines take() { return std::move(lines_); }

 private:
  struct Key {
    std::int64_t element;
    std::uint64_t line;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const {
      return static_cast<std::size_t>((static_cast<std::uint64_t>(key.element) * 0x9E3779B97F4A7C15ULL) ^
                                      (key.line * 0xC2B2AE3D27D4EB4FULL));
    }
  };
  Index point(const Key& key, const Point& position);

  const Mesh& mesh_;
  SurfaceLines lines_;
  std::unordered_map<Key, Index, KeyHash> point_of_;
  std::unordered_map<Key, Index, KeyHash> segment_of_;
};

// ---- Lines of equal value of a field given at the vertices

/// How a field varies along an edge between the values at its ends.
enum class Interpolation {
  linear,   ///< for any field
  distance  ///< as the distance from a point of the plane that has these distances from the ends: exact on
            ///< flat parts of the surface. Where the values differ by more than the edge's length: linear.
};

/// Isolines and the level of each of their points and segments.
struct Isolines {
  SurfaceLines lines;
  std::vector<Index> level_of_point;    ///< position in the list of levels
  std::vector<Index> level_of_segment;  ///< likewise
};

/// The lines on which the field has one of the levels: in each face at most one segment per level, straight
/// between two of its edges. Faces with a value that is not finite (unreachable) hold no line.
/// \throw InvalidInput if there are not as many values as vertices, or a level is not finite;
/// NotEnoughMemory; Cancelled. Complexity: O(m log l + crossings + l log l) for l levels and m faces.
Isolines isolines(const Mesh& mesh, std::span<const double> values, std::span<const double> levels,
                  Interpolation interpolation, const Progress& progress = {});

/// \throw InvalidInput if a field has not one value for each vertex that was given, or a level is not finite.
void require_field_and_levels(const Mesh& mesh, std::span<const double> field,
                              std::span<const double> levels);

/// Refuses lines of levels for which there is no memory: `bytes` for each time that one crosses a face.
/// `values`: at all vertices of the mesh. \throw NotEnoughMemory. Complexity: O((l + m) log l).
void require_memory_for_levels(const Mesh& mesh, std::span<const double> values, std::vector<double> levels,
                               double bytes);

/// Where on an edge of the given length a field takes the value `level`, which lies between those at the
/// ends: a fraction in [0, 1], counted from the first end.
double crossing(double at_first, double at_second, double length, double level, Interpolation interpolation);

/// Calls visit(edge, fraction along it, falls) for the two sides of a face on which a field passes a level,
/// if there are any; `falls`: whether the side begins at or above the level, in the direction of the face.
template <class Visit>
void for_each_crossing(const Mesh& mesh, std::span<const double> values, Index face, double level,
                       Interpolation interpolation, Visit&& visit) {
  const auto& corners = mesh.face_vertices(face);
  for (int i = 0; i < 3; ++i) {
    const bool falls = values[corners[i]] >= level;
    if (falls == (values[corners[(i + 1) % 3]] >= level)) continue;
    const Index edge = mesh.edge_of(3 * face + i);
    const auto [a, b] = mesh.edge_vertices(edge);
    visit(edge, crossing(values[a], values[b], mesh.edge_length(edge), level, interpolation), falls);
  }
}

}  // namespace vorogeo
