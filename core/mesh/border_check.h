// Borders of a mesh: closed loops of border edges, and borders that nearly touch though no short path joins
// them.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// The closed loops of border edges. Where borders meet at a vertex, each continues along the faces it
/// bounds.
struct BorderLoops {
  Index count = 0;
  Index longest_edges = 0;          ///< edges of the longest loop
  Index longest_vertex = no_index;  ///< its lowest-numbered vertex
  double longest_length = 0.0;
};

/// Border vertices that have another border vertex nearer than a tenth of the border edges at both, but no
/// path along edges to it shorter than one and a half of these: gaps that a program left open, or slits.
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

}  // namespace vorogeo
