// What is unusual about a mesh, counted and said in sentences.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/gaps.h"
#include "mesh/mesh.h"

namespace vorogeo {

// ---- Borders of a mesh: closed loops, and borders that nearly touch

/// The closed loops of border edges. Where borders meet at a vertex, each continues along the faces it
/// bounds.
struct BorderLoops {
  Index count = 0;
  Index longest_edges = 0;          ///< edges of the longest loop
  Index longest_vertex = no_index;  ///< its lowest-numbered vertex
  double longest_length = 0.0;
};

/// Border vertices that have another border vertex nearer than a tenth of the mean border edge at each, but
/// no path along edges to it of at most one and a half such edges: gaps that a program left open, or slits.
struct NearBorders {
  Index count = 0;  ///< vertices with such a neighbour
  Index first = no_index;
  std::array<Index, 2> closest{no_index, no_index};
  double least = 0.0;     ///< distance of the closest pair
  double greatest = 0.0;  ///< largest distance of such a vertex from its nearest such neighbour
};

/// By edge, a number that the edges of one border loop share; no_index for edges inside the surface.
/// Complexity: O(m) for m faces.
std::vector<Index> border_loops_of_edges(const Mesh& mesh);
/// Complexity: O(m) for m faces.
BorderLoops find_border_loops(const Mesh& mesh);

/// Edge lengths must be within exact_lengths. Complexity: O(b log b) for b border vertices: each examines a
/// bounded number of others and of edges around it.
NearBorders find_near_borders(const Mesh& mesh);

/// Groups of the faces around a vertex that are connected across edges at the vertex: one number for each
/// corner of the vertex, the same for corners of one group. Complexity: O(k log k) for k corners.
std::vector<Index> face_groups(const Mesh& mesh, Index vertex);

// ---- T-junctions: vertices that lie inside a border edge of a face to which they do not belong

/// A gap without width: one side of it is split at a vertex, the other is not, so no path crosses it.
struct TJunctions {
  Index count = 0;                                      ///< vertices inside a border edge
  Index first = no_index;                               ///< the first of them
  std::array<Index, 2> first_edge{no_index, no_index};  ///< ends of the edge it lies in
};

/// Vertices count as inside an edge if their distance from it is no more than rounding to single precision
/// explains. Edge lengths must be within exact_lengths. Complexity: O(b log b) for b border edges.
TJunctions find_t_junctions(const Mesh& mesh);

// ---- What a mesh contains that a user should know before trusting distances on it

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
  MeshFinding rounded_edges;               ///< whose length has fewer than four digits; first: a vertex
  MeshFinding outliers;                    ///< far from the rest of their component (mesh/outliers.h)
  MeshFinding t_junctions;                 ///< inside a border edge of another face (mesh/mesh_check.h)
  double outlier_ratio = 0.0;              ///< shortest edge from an outlier to the rest, in typical edges
  std::array<Index, 2> first_non_manifold_edge{no_index, no_index};
  std::array<Index, 2> first_t_junction_edge{no_index, no_index};
  Index border_edges = 0;
  Index components = 0;                        ///< that have a face
  std::vector<MeshComponent> component_sizes;  ///< most vertices first
  // If a vertex is not finite, the members below (but `gap`), outliers, rounded_edges and t_junctions keep
  // these values; near_borders, t_junctions and what bridges would join also if the edge lengths are not
  // within exact_lengths.
  double mean_edge_length = 0.0;
  double longest_edge_length = 0.0;
  BorderLoops border_loops;
  NearBorders near_borders;
  /// A gap with which all faces are one component, mostly the least; 0 if they are, `unreachable` if there is
  /// no such gap.
  double gap_to_join_all = 0.0;
  GapLimit gap;                         ///< the one the report was asked for
  Index joined_borders = 0;             ///< border loops that it joins with others or with themselves
  Index components_after_bridging = 0;  ///< that have a face

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
