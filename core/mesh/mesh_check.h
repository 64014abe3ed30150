// What a mesh contains that a user should know before trusting distances on it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/border_check.h"
#include "mesh/gap_bridges.h"
#include "mesh/length_limits.h"
#include "mesh/mesh.h"

namespace vorogeo {

/// One kind of finding: how many elements, and the first of them.
struct MeshFinding {
  Index count = 0;
  Index first = no_index;
};

/// A connected part of a mesh.
struct MeshComponent {
  Index vertices = 0;
  Index faces = 0;
  Index first_vertex = no_index;
};

/// Report on a triangle soup before it becomes a Mesh; faces and vertices by their input indices.
struct MeshReport {
  Index vertices = 0;
  Index faces = 0;
  MeshFinding non_finite_vertices;         ///< refused by Mesh
  MeshFinding faces_out_of_range;          ///< refused by Mesh
  MeshFinding faces_with_repeated_vertex;  ///< left out
  MeshFinding duplicate_faces;             ///< left out
  MeshFinding zero_area_faces;             ///< crossed at no cost, no area
  MeshFinding duplicate_vertices;          ///< same position as an earlier vertex; not joined
  MeshFinding isolated_vertices;           ///< unreachable
  MeshFinding non_manifold_edges;          ///< paths may turn into any of their faces
  MeshFinding non_manifold_vertices;       ///< paths may pass from any face to any other
  MeshFinding inconsistent_edges;          ///< two faces of opposite orientation: no effect
  MeshFinding outliers;                    ///< far from the rest of their component (mesh/outliers.h)
  MeshFinding t_junctions;                 ///< inside a border edge of another face (mesh/t_junctions.h)
  double outlier_ratio = 0.0;              ///< shortest edge from an outlier to the rest, in typical edges
  std::array<Index, 2> first_non_manifold_edge{no_index, no_index};
  std::array<Index, 2> first_t_junction_edge{no_index, no_index};
  Index border_edges = 0;
  Index components = 0;                        ///< of vertices with a face
  std::vector<MeshComponent> component_sizes;  ///< most vertices first
  // The members below keep these values if a vertex is not finite; near_borders and t_junctions also if the
  // edge lengths are not within exact_lengths.
  double mean_edge_length = 0.0;
  double longest_edge_length = 0.0;
  BorderLoops border_loops;
  NearBorders near_borders;
  /// The least gap with which all faces are one component; 0 if they are, `unreachable` if none would do.
  double gap_to_join_all = 0.0;
  GapLimit gap;                         ///< the one the report was asked for
  Index joined_borders = 0;             ///< border loops that it joins with others or with themselves
  Index components_after_bridging = 0;  ///< of vertices with a face

  bool fits(const LengthLimits& limits) const { return limits.allow(mean_edge_length, longest_edge_length); }
  /// Whether distances can be computed: false if a Mesh cannot be made from it or it is too large or small.
  bool usable() const {
    return faces > 0 && non_finite_vertices.count == 0 && faces_out_of_range.count == 0 &&
           fits(exact_lengths);
  }
  /// Whether an index can be built, memory permitting.
  bool usable_by_index() const { return usable() && fits(index_lengths); }
  /// What may surprise a user: one sentence for each kind of finding, each naming its first element.
  std::vector<std::string> sentences() const;
  /// Sizes, components and borders in one sentence.
  std::string summary() const;
};

/// Never throws on bad geometry. `gap`: what would be bridged is reported, too. \throw InvalidInput for a gap
/// that is negative or not finite. Complexity O(n log n + m log m).
MeshReport check_mesh(const std::vector<Point>& positions, const std::vector<std::array<Index, 3>>& faces,
                      const GapLimit& gap = {});

}  // namespace vorogeo
