// The chain of border vertices of a route, and the strip of faces along it.
#pragma once

#include <vector>

#include "index/index_data.h"
#include "mesh/mesh.h"
#include "mesh/surface_point.h"
#include "query/route.h"
#include "query/path_line.h"

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

/// An end point in the mesh over which strips of faces are laid: the work mesh of an index, or the user's.
struct PathEnd {
  PathEnd(const Mesh& mesh, const SurfacePoint& point);
  /// Of a point of the user's mesh, in the work mesh.
  PathEnd(const IndexData& data, const SurfacePoint& user);

  SurfacePoint point;
  Index vertex = no_index;     ///< the point itself or the nearest corner of its face
  double to_vertex = 0.0;      ///< distance of the point from that vertex
  std::vector<Index> patches;  ///< second-layer patches at the point; none without an index

  /// Second-layer patch of an end in a face; no_index for a vertex.
  Index patch(const IndexData& data) const {
    return point.is_vertex() ? no_index : data.work.second_layer[point.face];
  }
};

/// Whether a second-layer patch of one end is or touches one of the other.
bool are_near(const IndexData& data, const PathEnd& a, const PathEnd& b);

/// The border nodes of the end's patch with their distances from it.
RouteEnd route_end_of(const IndexData& data, const PathEnd& end);

// ---- From a route to a chain of second-layer border vertices, each in a patch of the previous one

/// A step of a chain: to `vertex` (work mesh) through the second-layer patch `patch`. A step that begins or
/// ends at a border vertex of the patch can be followed by that vertex's distances in the patch.
struct ChainStep {
  Index vertex;
  Index patch;
};

/// A shortest path through the tables: the source, then a step for each second-layer patch passed.
struct PathChain {
  Index source = no_index;
  std::vector<ChainStep> steps;
};

/// Resolves a route between two work vertices into second-layer steps: a leg by the transit table into steps
/// between first-layer nodes of one first-layer patch, each of these into steps between second-layer nodes of
/// one second-layer patch. In each layer the predecessor is a node with the least sum. Complexity: O(b) for
/// each step, with b border nodes of the patches at its end. `source_patch`, `target_patch`: second-layer
/// patches that the route's first and last node share with the ends, for ends that may lie on a border;
/// no_index for the patches of vertices inside one.
PathChain chain_of_route(const IndexData& data, const GraphRoute& route, Index source, Index target,
                         Index source_patch = no_index, Index target_patch = no_index);

// ---- A strip of faces along a chain of border vertices

/// Follows every step of the chain through its patch: from one end towards the other, which is a border
/// vertex, down the distances of that vertex. In each face the distances of two vertices place the goal in
/// the plane of the face; the straight line towards it leads on. `strip` has its end points (work mesh) set;
/// its faces are filled in. \return false if a table does not lead to the end of its step. Complexity:
/// O(faces).
bool strip_along_chain(const IndexData& data, const PathChain& chain, FaceStrip& strip);

// ---- A walk over the faces of a patch, down the distances of a border vertex

/// A face that was passed and how it was reached: across an edge, or around a vertex.
struct PassedFace {
  Index face;
  Index exit;   ///< half-edge of the previous face; no_index: around `pivot`
  Index entry;  ///< half-edge of this face
  Index pivot;
};

/// Walks from `start` to the border vertex `goal` of a patch; along edges if there is no patch, and from
/// where the distances lead out of it.
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
  bool arrived() const { return vertex_ == goal_; }
  /// The faces passed so far.
  const std::vector<PassedFace>& passed() const { return passed_; }

 private:
  enum class Next {
    meet_vertex,
    look_around,
    look_up_ring,
    leave_vertex,
    find_apex,
    look_up_apex,
    cross_face,
    nothing
  };
  /// Where to go from a point of a face: across an edge at a position, or to a vertex.
  struct Move {
    double length = unreachable;
    Index face = no_index;
    Index vertex = no_index;
    Index halfedge = no_index;
    double x = 0.0;  ///< position, from the first vertex of the edge
    double edge_length = 0.0;
    double at_first = unreachable;  ///< distance of the edge's first vertex
    double at_second = unreachable;
    Index first = no_index;  ///< that vertex
    Index second = no_index;
  };

  /// Prefetches what is needed to find the column of a vertex.
  void fetch_column(Index vertex) const;
  /// Prefetches the distance of a vertex. \return its column.
  Index fetch_distance(Index vertex) const;
  void meet_vertex();
  void leave();
  void enter_face();
  /// Enters the face of the last move, unless the walk is longer than it should be.
  void take_move(const PassedFace& face);
  void walk_along_edges();
  double distance_at(Index column) const;
  double distance(Index vertex) const;
  /// The straight line from a point (px, py >= 0) across an edge on the x axis to the point beyond that has
  /// the distances at_0 and at_length from the ends of the edge.
  static void through_edge(double px, double py, double length, double at_0, double at_length, Index halfedge,
                           Move& best);
  /// Only to vertices nearer to the goal than the last one, so that rounding of the tables causes no cycles.
  void to_vertex(double step, double from_there, Index face, Index vertex, Move& best) const;
  Move leave_vertex(Index vertex) const;
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
  Index vertex_;  ///< the last one met
  std::vector<PassedFace> passed_;
  Next next_ = Next::meet_vertex;

  // Counted from that vertex:
  std::size_t straight_from_ = 0;  ///< number of faces passed before
  std::size_t faces_left_ = 0;
  double at_last_ = unreachable;   ///< distance of that vertex
  double expected_ = unreachable;  ///< length that no continuation should exceed
  Move move_;
  Index entry_ = no_index;   ///< half-edge by which the next face is entered
  Index column_ = no_index;  ///< of that face's third corner
};

}  // namespace vorogeo
