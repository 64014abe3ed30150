// Building blocks of the bases and defects of hostile meshes.
#pragma once

#include <map>
#include <utility>

#include "support/hostile_meshes.h"

namespace vorogeo::test {

/// Where an edge lies in a face: face and corner at which it begins.
struct EdgeSide {
  std::size_t face;
  int corner;
};
using EdgeSides = std::map<std::pair<Index, Index>, std::vector<EdgeSide>>;

/// All edges by their two vertices, the smaller one first; faces that name a vertex twice are skipped.
EdgeSides edge_sides(const Soup& soup);
/// The two vertices of one edge.
using VertexPair = std::pair<Index, Index>;
/// Some different edges of those, in random order.
std::vector<VertexPair> random_edges(const EdgeSides& edges, std::size_t count, HostileRandom& random);
/// In random order.
template <class List>
void shuffle(List& list, HostileRandom& random) {
  for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.below(i)]);
}
/// The soup with vertex v at number[v].
Soup renumbered(const Soup& soup, const std::vector<Index>& number);
/// The vertices next to each vertex. Shape (n).
std::vector<std::vector<Index>> neighbours_of(const Soup& soup);
/// The median length of the edges that have one: outliers do not change it. 1 if there is none.
double typical_edge(const Soup& soup);

inline Point mix(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}
inline Point moved(const Point& p, const Point& direction, double by) {
  return {p[0] + by * direction[0], p[1] + by * direction[1], p[2] + by * direction[2]};
}

inline double height_over(const Point& normal, const Point& p) {
  return normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2];
}
/// Along an axis, or in any direction.
Point random_normal(HostileRandom& random);
/// Splits the faces that a plane crosses. \return by face, whether it lies above the plane.
std::vector<std::uint8_t> cut_by_plane(HostileMesh& mesh, const Point& normal, double at);

/// A vertex at the fraction `t` of the segment from a to b, also in the unrolled surface.
Index add_vertex_between(HostileMesh& mesh, Index a, Index b, double t);
/// A vertex anywhere, whose place in the unrolled surface is unknown.
Index add_vertex(HostileMesh& mesh, const Point& position);

/// About 1 to 5 % of the elements, at least one.
std::size_t a_few(std::size_t elements, HostileRandom& random);
/// "3 fins", "1 fin".
std::string counted(std::size_t count, const std::string& noun);
/// "1e+07", "0.25": short.
std::string short_number(double value);

/// Cuts ears off a polygon that is counter-clockwise in the plane of x and y; as coarse as caps of CAD
/// programs.
void add_cap(Soup& soup, std::vector<Index> outline, bool upwards);
/// One closed or open scrap of a few faces at `centre`: triangle, tetrahedron or two-sided quad.
void add_crumb(Soup& soup, const Point& centre, double size, HostileRandom& random);

}  // namespace vorogeo::test
