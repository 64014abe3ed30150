// One walk over the faces of a patch, down the distances of a border vertex.
#pragma once

#include <vector>

#include "path/path_chain.h"

namespace vorogeo {

/// A face on the way and how it was come to: across an edge, or around a vertex.
struct PassedFace {
  Index face;
  Index exit;   ///< half-edge of the face before; no_index: around `pivot`
  Index entry;  ///< half-edge of this face
  Index pivot;
};

/// Walks from `start` to the border vertex `goal` of a patch; along edges from where the distances lead out
/// of the patch, or if there is no patch.
///
/// What a walk reads next may lie anywhere in memory, and its address is known only from what was read
/// before. So a walk pauses after each request, and others go on while the memory answers.
///
/// A walk ends: each vertex it meets is nearer to the goal than the last one, and between two vertices it may
/// pass only so many faces; then it goes on along edges.
class StepWalk {
 public:
  StepWalk(const IndexData& data, Index patch, Index start, Index goal);

  /// Goes on until something has to be fetched. \return false at the end of the walk.
  bool go_on();

  /// Whether the walk has come to its goal.
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
    double x = 0.0;  ///< from the first vertex of the edge
    double edge_length = 0.0;
    double at_first = unreachable;  ///< distance of the edge's first vertex
    double at_second = unreachable;
    Index first = no_index;  ///< that vertex
    Index second = no_index;
  };

  /// What the column of a vertex is found by.
  void fetch_column(Index vertex) const;
  /// Its distance. \return its column.
  Index fetch_distance(Index vertex) const;
  void meet_vertex();
  void leave();
  void enter_face();
  /// Into the face of the last move, unless the way is longer than it should be.
  void take_move(const PassedFace& face);
  void walk_along_edges();
  double distance_at(Index column) const;
  double distance(Index vertex) const;
  /// The way from a point (px, py >= 0) across an edge on the x axis to the point beyond that has the
  /// distances at_0 and at_length from the ends of the edge.
  static void through_edge(double px, double py, double length, double at_0, double at_length, Index halfedge,
                           Move& best);
  /// Only to vertices nearer to the goal than the last one, so that rounding of the tables makes no circles.
  void to_vertex(double step, double from_there, Index face, Index vertex, Move& best) const;
  Move leave_vertex(Index vertex) const;
  /// From the point where the last move came to the edge of a half-edge across its face. The ends of the edge
  /// and their distances come with the move, and lengths from the frame: what is read from elsewhere is far
  /// away in memory.
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

  // Since that vertex.
  std::size_t straight_from_ = 0;  ///< faces passed before
  std::size_t faces_left_ = 0;
  double at_last_ = unreachable;   ///< its distance
  double expected_ = unreachable;  ///< no way on should be longer
  Move move_;
  Index entry_ = no_index;   ///< half-edge by which the next face is entered
  Index column_ = no_index;  ///< of that face's third corner
};

}  // namespace vorogeo
