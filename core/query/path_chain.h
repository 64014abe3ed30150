// The ends of paths, and the strips of faces along edges and along routes.
#pragma once

#include <optional>
#include <vector>

#include "index/index_data.h"
#include "index/inner_surface.h"
#include "mesh/mesh.h"
#include "mesh/surface_point.h"
#include "query/path_line.h"
#include "query/route.h"

namespace vorogeo {

// ---- The shortest path along edges

/// A face that was passed and how it was reached: across an edge, or past a place.
struct PassedFace {
  Index face;
  Index exit;   ///< half-edge of the previous face; no_index: past `pivot`
  Index entry;  ///< half-edge of this face
  Index pivot;  ///< a vertex of both faces, or a place inside an edge of both
};

/// The length of the shortest path along edges from one vertex to another (Hart, Nilsson, Raphael 1968);
/// unreachable if there is none. Adds a face beside each of its edges. Meant for short paths. Complexity: O(n
/// log n) for the n vertices visited.
double path_along_edges(const Mesh& mesh, Index start, Index goal, std::vector<PassedFace>& passed);

// ---- The end points of a path as the index sees them

/// An end point on the surface over which strips of faces are laid.
struct PathEnd {
  PathEnd(const Mesh& mesh, const SurfacePoint& point);

  SurfacePoint point;
  Index vertex = no_index;  ///< the point itself or the nearest corner of its face
  double to_vertex = 0.0;   ///< distance of the point from that vertex
};

/// An end point on the inner surface of an index.
struct IndexedEnd : PathEnd {
  /// The end at a point of the user's mesh.
  IndexedEnd(const IndexData& data, const SurfacePoint& user);

  Index patch = no_index;          ///< of the second layer, if the point is in a face
  std::vector<Index> patches;      ///< all second-layer patches at the point
  std::optional<FacePiece> piece;  ///< around the point, if it is in a face
  Index place = no_index;          ///< the point itself or the nearest corner of the piece
  double to_place = 0.0;           ///< distance of the point from that place

  /// The distance that `of_place` gives for the point's place; in a face, the one that follows from those of
  /// the corners of the piece.
  template <class OfPlace>
  double distance(OfPlace&& of_place) const {
    if (!piece) return of_place(place);
    return piece->distance({of_place(piece->place[0]), of_place(piece->place[1]), of_place(piece->place[2])});
  }
};

/// Whether a second-layer patch of one end is or touches one of the other.
bool are_near(const IndexData& data, const IndexedEnd& a, const IndexedEnd& b);

/// The border nodes of the end's patch with their distances from it.
RouteEnd route_end_of(const IndexData& data, const IndexedEnd& end);

// ---- The strip of faces along a route

/// Lays a strip of faces from end to end, in two steps. First the route is resolved into steps through
/// second-layer patches: a leg by the transit table into legs by tables of the first layer, each of these
/// into steps between second-layer nodes; in each layer the predecessor is a node with the least sum. Then
/// each step is followed through its patch, from one end towards the other, which is a border node, down the
/// distances of that node: in each face the distances of two vertices place the goal in the plane of the
/// face, and the straight line towards it leads on. \return false if a table does not lead to the end of its
/// step. Complexity: O(b) for each step, with b border nodes of the patches at its end, and O(faces).
bool strip_along_route(const IndexData& data, const GraphRoute& route, const IndexedEnd& from,
                       const IndexedEnd& to, FaceStrip& strip);

}  // namespace vorogeo
