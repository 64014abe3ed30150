// The chain of border vertices of a route, and the strip of faces along it.
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

/// An edge on the path, as the half-edge of an adjacent face, and the vertex it leaves: its tail or its head.
struct EdgeStep {
  Index halfedge;
  Index from;
};

/// Adds the shortest path along edges from one vertex to another (Hart, Nilsson, Raphael 1968); meant for
/// short paths. \return false if there is none. Complexity: O(n log n) for the n vertices visited.
bool path_along_edges(const Mesh& mesh, Index start, Index goal, std::vector<EdgeStep>& path);

// ---- The end points of a path as the index sees them

/// An end point on the surface over which strips of faces are laid.
struct PathEnd {
  PathEnd(const Mesh& mesh, const SurfacePoint& point);

  SurfacePoint point;
  Index vertex = no_index;  ///< the point itself or the nearest corner of its face
  double to_vertex = 0.0;   ///< distance of the point from that vertex
};

/// One on the inner surface of an index.
struct IndexedEnd : PathEnd {
  /// Of a point of the user's mesh.
  IndexedEnd(const IndexData& data, const SurfacePoint& user);

  Index patch = no_index;          ///< of the second layer, if the point is in a face
  std::vector<Index> patches;      ///< all at the point
  std::optional<FacePiece> piece;  ///< around the point, if it is in a face
  Index place = no_index;          ///< the point itself or the nearest corner of the piece
  double to_place = 0.0;           ///< distance of the point from that

  /// What `of_place` gives for the point itself, or the distance that follows from those of the piece's
  /// corners.
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

// ---- From a route to a chain of second-layer border vertices, each in a patch of the previous one

/// A step of a chain: to a place through a second-layer patch. A step that begins or ends at a border node of
/// the patch can be followed by that node's distances in the patch.
struct ChainStep {
  Index place;
  Index patch;
};

/// A shortest path through the tables: the source, then a step for each second-layer patch passed.
struct PathChain {
  Index source = no_index;
  std::vector<ChainStep> steps;
};

/// Resolves a route between two places into second-layer steps: a leg by the transit table into steps
/// between first-layer nodes of one first-layer patch, each of these into steps between second-layer nodes of
/// one second-layer patch. In each layer the predecessor is a node with the least sum. Complexity: O(b) for
/// each step, with b border nodes of the patches at its end. `source_patch`, `target_patch`: second-layer
/// patches that the route's first and last node share with the ends, for ends that may lie on a border;
/// no_index for the patches of vertices inside one.
PathChain chain_of_route(const IndexData& data, const GraphRoute& route, Index source, Index target,
                         Index source_patch = no_index, Index target_patch = no_index);

// ---- A strip of faces along a chain of border vertices

/// Follows every step of the chain through its patch: from one end towards the other, which is a border
/// node, down the distances of that node. In each face the distances of two vertices place the goal in the
/// plane of the face; the straight line towards it leads on. `strip` has its end points set; its faces are
/// filled in. \return false if a table does not lead to the end of its step. Complexity: O(faces).
bool strip_along_chain(const IndexData& data, const PathChain& chain, FaceStrip& strip);

// ---- A walk over the faces of a patch, down the distances of a border vertex

/// A face that was passed and how it was reached: across an edge, or past a place.
struct PassedFace {
  Index face;
  Index exit;   ///< half-edge of the previous face; no_index: past `pivot`
  Index entry;  ///< half-edge of this face
  Index pivot;  ///< a vertex of both faces, or a place inside an edge of both
};

/// Walks from the place `start` to the border node at `goal` in a patch; along edges if there is no patch,
/// and from where the distances lead out of it.
///
/// Each step is a cache miss, at an address that depends on the previous one. So a walk pauses after each
/// prefetch, and other walks continue until the data has arrived.
///
/// A walk terminates: each vertex that it meets is nearer to the goal than the previous one, and after a
/// bounded number of faces between two vertices it continues along edges.
class StepWalk {
 public:
  StepWalk(const IndexData& data, Index patch, Index start, Index goal);

  /// Continues until something has to be fetched. \return false at the end of the walk.
  bool go_on();

  /// Whether the walk has reached its goal.
  bool arrived() const { return place_ == goal_; }
  /// The faces passed so far.
  const std::vector<PassedFace>& passed() const { return passed_; }

 private:
  enum class Next {
    meet_place,
    look_around,
    look_up_ring,
    leave_place,
    find_apex,
    look_up_apex,
    cross_face,
    nothing
  };
  /// Where to go from a point of a face: across an edge at a position, or to a place.
  struct Move {
    double length = unreachable;
    Index face = no_index;
    Index place = no_index;
    Index halfedge = no_index;
    double x = 0.0;  ///< position, from the first vertex of the edge
    double edge_length = 0.0;
    double at_first = unreachable;  ///< distance of the edge's first vertex
    double at_second = unreachable;
    Index first = no_index;  ///< that vertex
    Index second = no_index;
  };

  /// Calls visit(vertex) for the vertices next to the place where the walk is.
  template <class Visit>
  void for_each_neighbour(Visit&& visit) const;
  /// Prefetches what is needed to find the column of a vertex.
  void fetch_column(Index vertex) const;
  /// Prefetches the distance of a vertex. \return its column.
  Index fetch_distance(Index vertex) const;
  void meet_place();
  void leave();
  void enter_face();
  /// Enters the face of the last move, unless the walk is longer than it should be.
  void take_move(const PassedFace& face);
  void walk_along_edges();
  double distance_at(Index column) const;
  double distance(Index place) const;
  /// The straight line from a point (px, py >= 0) across an edge on the x axis to the point beyond that has
  /// the distances at_0 and at_length from the ends of the edge.
  static void through_edge(double px, double py, double length, double at_0, double at_length, Index halfedge,
                           Move& best);
  /// Only to vertices nearer to the goal than the last one, so that rounding of the tables causes no cycles.
  void to_vertex(double step, double from_there, Index face, Index vertex, Move& best) const;
  /// Straight to the goal, if it is a place inside a side of the face and the walk has come to `x` on the
  /// edge of `halfedge`, or to the corner opposite that edge (off_the_edge).
  Move to_goal_in_face(Index halfedge, double x) const;
  Move leave_vertex(Index vertex) const;
  Move leave_point(const EdgePoint& point) const;
  /// Across the face of a half-edge, from the point at which the last move reached its edge. The ends of the
  /// edge and their distances come with the move, and lengths from the frame: reading them elsewhere would be
  /// a cache miss.
  Move cross(Index halfedge, const Move& last, double at_apex) const;

  const IndexData& data_;
  const Mesh& mesh_;
  const ExactGeometry& geometry_;
  Index patch_;
  Index row_;
  Index goal_;
  Index goal_edge_;  ///< that it is inside; no_index if it is a vertex
  Index place_;      ///< the last one met
  std::vector<PassedFace> passed_;
  Next next_ = Next::meet_place;

  // Counted from that place:
  std::size_t straight_from_ = 0;  ///< number of faces passed before
  std::size_t faces_left_ = 0;
  double at_last_ = unreachable;   ///< distance of that place
  double expected_ = unreachable;  ///< length that no continuation should exceed
  Move move_;
  Index entry_ = no_index;   ///< half-edge by which the next face is entered
  Index column_ = no_index;  ///< of that face's third corner
};

}  // namespace vorogeo
