// A walk over the faces of a patch, down the distances of a border vertex.
#pragma once

#include <vector>

#include "path/path_chain.h"

namespace vorogeo {

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
