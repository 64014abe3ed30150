// In each face the distances of two vertices are unfolded into the plane.
#include "path/step_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "path/path_edges.h"
#include "support/prefetch.h"

namespace vorogeo {

namespace {

/// A walk is abandoned when it becomes this many times as long as it should be.
constexpr double longer = 1.1;

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace

StepWalk::StepWalk(const IndexData& data, Index patch, Index start, Index goal)
    : data_(data),
      mesh_(*data.work.mesh),
      geometry_(*data.geometry->windows),
      patch_(patch),
      row_(patch == no_index ? no_index : data.row_in_patch(patch, goal)),
      goal_(goal),
      vertex_(start) {
  passed_.reserve(64);
}

bool StepWalk::go_on() {
  switch (next_) {
    case Next::meet_vertex:
      meet_vertex();
      break;
    case Next::look_around:
      for (Index corner : mesh_.corners(vertex_)) fetch_column(mesh_.head(corner));
      next_ = Next::look_up_ring;
      break;
    case Next::look_up_ring:
      for (Index corner : mesh_.corners(vertex_)) fetch_distance(mesh_.head(corner));
      next_ = Next::leave_vertex;
      break;
    case Next::leave_vertex:
      leave();
      break;
    case Next::find_apex:
      fetch_column(geometry_.frame[entry_].apex);
      next_ = Next::look_up_apex;
      break;
    case Next::look_up_apex:
      column_ = fetch_distance(geometry_.frame[entry_].apex);
      next_ = Next::cross_face;
      break;
    case Next::cross_face:
      enter_face();
      break;
    case Next::nothing:
      break;
  }
  return next_ != Next::nothing;
}

void StepWalk::fetch_column(Index vertex) const {
  prefetch_line(&data_.second.vertex_node[vertex]);
  prefetch_line(&data_.home_patch[vertex]);
  prefetch_line(&data_.home_column[vertex]);
}

Index StepWalk::fetch_distance(Index vertex) const {
  const Index column = data_.column_in_patch(patch_, vertex);
  if (column != no_index) {
    const PatchLayer::Column entries = data_.second.column_of(patch_, column);
    prefetch_line(entries.first + static_cast<std::size_t>(row_) * entries.step);
  }
  return column;
}

void StepWalk::meet_vertex() {
  if (vertex_ == goal_) {
    next_ = Next::nothing;
    return;
  }
  if (row_ == no_index) {
    walk_along_edges();
    return;
  }
  for (Index corner : mesh_.corners(vertex_)) {
    const Index opposite = Mesh::next_in_face(corner);
    prefetch_line(&geometry_.frame[opposite]);
    prefetch_line(&mesh_.face_vertices(Mesh::face_of(corner)));
    mesh_.prefetch_around_edge(opposite);
  }
  next_ = Next::look_around;
}

void StepWalk::leave() {
  straight_from_ = passed_.size();
  at_last_ = distance(vertex_);
  expected_ = at_last_ * longer;
  faces_left_ = 4 * static_cast<std::size_t>(data_.second.member_count(patch_)) + 64;
  move_ = leave_vertex(vertex_);
  take_move({move_.face, no_index, no_index, vertex_});
}

void StepWalk::enter_face() {
  const Index exit = move_.halfedge;
  expected_ = std::min(expected_, move_.length * longer);
  move_ = cross(entry_, move_, distance_at(column_));
  take_move({Mesh::face_of(entry_), exit, entry_, no_index});
}

void StepWalk::take_move(const PassedFace& face) {
  if (move_.face == no_index || move_.length > expected_ || --faces_left_ == 0) {
    passed_.resize(straight_from_);
    walk_along_edges();
    return;
  }
  passed_.push_back(face);
  if (move_.vertex != no_index) {
    vertex_ = move_.vertex;
    next_ = Next::meet_vertex;
    return;
  }
  entry_ = mesh_.next_around_edge(move_.halfedge);
  prefetch_line(&geometry_.frame[entry_]);
  mesh_.prefetch_around_edge(entry_);
  next_ = Next::find_apex;
}

void StepWalk::walk_along_edges() {
  std::vector<EdgeStep> path;
  if (path_along_edges(mesh_, vertex_, goal_, path)) vertex_ = goal_;
  for (const EdgeStep& step : path) {
    passed_.push_back({Mesh::face_of(step.halfedge), no_index, no_index, step.from});
  }
  next_ = Next::nothing;
}

double StepWalk::distance_at(Index column) const {
  return column == no_index ? unreachable : data_.second.distance(patch_, row_, column);
}

double StepWalk::distance(Index vertex) const { return distance_at(data_.column_in_patch(patch_, vertex)); }

void StepWalk::through_edge(double px, double py, double length, double at_0, double at_length,
                            Index halfedge, Move& best) {
  if (!(at_0 < unreachable && at_length < unreachable && length > 0.0)) return;
  const double difference = at_0 - at_length;
  if (std::abs(difference) > length) return;
  const double x = 0.5 * (length + difference * (at_0 + at_length) / length);
  const double y = std::sqrt(std::max(0.0, (at_0 - x) * (at_0 + x)));
  if (!(y + py > 0.0)) return;
  const double crossing = px + (x - px) * (py / (y + py));
  if (!(crossing > 0.0 && crossing < length)) return;
  const double step_length = length_of(x - px, y + py);
  if (step_length < best.length) {
    best = {step_length, Mesh::face_of(halfedge), no_index, halfedge, crossing, length, at_0, at_length};
  }
}

void StepWalk::to_vertex(double step, double from_there, Index face, Index vertex, Move& best) const {
  if (from_there < at_last_ && step + from_there < best.length) {
    best = {step + from_there, face, vertex};
  }
}

StepWalk::Move StepWalk::leave_vertex(Index vertex) const {
  Move best;
  // Neighbours are consecutive in the fan: each is an end of two of the opposite edges.
  std::array<Index, 2> known{no_index, no_index};
  std::array<double, 2> at{unreachable, unreachable};
  for (Index corner : mesh_.corners(vertex)) {
    const Index opposite = Mesh::next_in_face(corner);
    const Index face = Mesh::face_of(corner);
    const FaceFrame& frame = geometry_.frame[opposite];
    std::array<Index, 2> ends{mesh_.tail(opposite), mesh_.head(opposite)};
    if (!frame.along) std::swap(ends[0], ends[1]);
    std::array<double, 2> there{};
    for (int i = 0; i < 2; ++i) {
      const bool is_known = ends[i] == known[0] || ends[i] == known[1];
      there[i] = is_known ? at[ends[i] == known[0] ? 0 : 1] : distance(ends[i]);
      if (is_known) continue;
      const Index side = mesh_.head(corner) == ends[i] ? corner : Mesh::previous_in_face(corner);
      to_vertex(mesh_.edge_length(mesh_.edge_of(side)), there[i], face, ends[i], best);
    }
    known = ends;
    at = there;
    if (mesh_.next_around_edge(opposite) == opposite) continue;
    through_edge(frame.apex_x, frame.apex_depth, mesh_.edge_length(mesh_.edge_of(opposite)), there[0],
                 there[1], opposite, best);
    if (best.halfedge == opposite) {
      best.first = ends[0];
      best.second = ends[1];
    }
  }
  return best;
}

StepWalk::Move StepWalk::cross(Index halfedge, const Move& last, double at_apex) const {
  const double x = last.x;
  const FaceFrame& frame = geometry_.frame[halfedge];
  const double length = last.edge_length;
  const Index face = Mesh::face_of(halfedge);
  Move best;
  to_vertex(length_of(frame.apex_x - x, frame.apex_depth), at_apex, face, frame.apex, best);
  to_vertex(x, last.at_first, face, last.first, best);
  to_vertex(length - x, last.at_second, face, last.second, best);
  for (const bool first : {true, false}) {
    const Index side = first ? frame.first_side(halfedge) : frame.second_side(halfedge);
    // The point in the frame of the side, whose x axis begins at the vertex that it shares with the crossed
    // edge.
    const double from_shared = first ? x : length - x;
    const double along = first ? frame.apex_x : length - frame.apex_x;
    const double side_length = length_of(along, frame.apex_depth);
    if (!(side_length > 0.0) || mesh_.next_around_edge(side) == side) continue;
    const double cosine = along / side_length;
    const double sine = frame.apex_depth / side_length;
    Move move;
    through_edge(from_shared * cosine, from_shared * sine, side_length,
                 first ? last.at_first : last.at_second, at_apex, side, move);
    if (!(move.length < best.length)) continue;
    move.first = first ? last.first : last.second;
    move.second = frame.apex;
    if (first ? frame.first_side_reversed : frame.second_side_reversed) {
      move.x = side_length - move.x;
      std::swap(move.first, move.second);
      std::swap(move.at_first, move.at_second);
    }
    best = move;
  }
  return best;
}

}  // namespace vorogeo
