// From the points of a side, and from between them, into a face.
#include <algorithm>
#include <array>
#include <cmath>

#include "weighted/edge_crossing.h"
#include "weighted/weighted_solver.h"

namespace vorogeo {

namespace {

/// Of the cost of a piece: what the slopes of one wave at its ends are off by.
constexpr double slope_slack = 0.3;

}  // namespace

/// Whether the distances of the ends of a piece can be those of one wave: along an edge, these grow ever
/// faster. Where two waves meet, they would place a source that is none, and distances behind it be too
/// short.
bool WeightedSolver::is_one_wave(Index edge, Index first) const {
  const PointState& a = state_[norms_->point(edge, first)];
  const PointState& b = state_[norms_->point(edge, first + 1)];
  const double cost = norms_->fraction(1) * norms_->edge_cost(edge);
  const double rise = b.distance - a.distance;
  // A vertex belongs to many edges.
  const bool bends_at_first = first > 0 && cost * a.slope > rise + slope_slack * cost;
  const bool bends_at_second =
      first < norms_->points_per_edge() && rise > cost * b.slope + slope_slack * cost;
  return !bends_at_first && !bends_at_second;
}

/// Where the wave between a point of an edge and the next one comes from. `length`: of the piece, in the face
/// that is entered.
PlacedSource WeightedSolver::placed_source(Index edge, Index first, double length) const {
  if (!is_one_wave(edge, first)) return {};
  const PointState& a = state_[norms_->point(edge, first)];
  const PointState& b = state_[norms_->point(edge, first + 1)];
  // A vertex belongs to edges with many cheapest faces. Where two waves meet, the flatter one is not too
  // short.
  const double at_first = first == 0 ? 0.0 : a.farther();
  const double at_second = first == norms_->points_per_edge() ? 0.0 : b.farther();
  return PlacedSource({length, norms_->edge_cost(edge) * norms_->fraction(1), a.distance, b.distance,
                       std::max(at_first, at_second)});
}

/// Crosses a face from a point of a side, and from between it and those beside it that are settled, to the
/// points of the other two sides.
void WeightedSolver::cross_from(Index halfedge, Index from) {
  if (norms_->in_thin_fan(Mesh::face_of(halfedge))) {
    cross_thin(halfedge, from);
    return;
  }
  const EdgeFrame frame = norms_->frame(halfedge);
  const Index edge = mesh().edge_of(halfedge);
  const Index last = norms_->points_per_edge() + 1;
  const double spacing = norms_->fraction(1);
  const double at = norms_->fraction(from) * frame.length;
  const PointState own = state_[norms_->point(edge, from)];
  const double cost = norms_->edge_cost(edge);
  const double dearer = cost > 0.0 ? frame.length / cost : 1.0;
  struct Piece {
    PlacedSource source;
    double begin = 0.0;
    Index nearest = no_index;
  };
  std::array<Piece, 2> pieces;
  int piece_count = 0;
  double least = own.distance;
  for (const Index begin : {from - 1, from}) {
    if (begin < 0 || begin == last) continue;
    const PointState& other = state_[norms_->point(edge, begin == from ? from + 1 : begin)];
    // A point beside this one that is settled later crosses the piece itself.
    if (!(other.settled || other.distance <= own.distance)) continue;
    Piece& piece = pieces[piece_count];
    piece.source = placed_source(edge, begin, frame.length * spacing);
    if (!piece.source.exists()) continue;
    piece.begin = norms_->fraction(begin) * frame.length;
    piece.nearest = other.distance < own.distance ? other.source : own.source;
    least = std::min(least, piece.source.least());
    ++piece_count;
  }
  /// `side`: the direction of the side that the point is on, in this face; `side_dearer`: as of RayAtEdge;
  /// `sign`: -1 if the direction is not that of its edge.
  auto look = [&](Index point, double x, double y, const FaceNorms::Place& side, double side_dearer,
                  double sign) {
    const double known = state_[point].distance;
    if (!(least + y < known)) return;
    double best = own.distance + std::sqrt((x - at) * (x - at) + y * y);
    double crossing = at;
    Index source = own.source;
    double farther = norms_->is_vertex(norms_->point(edge, from)) ? 0.0 : own.farther();
    for (int i = 0; i < piece_count; ++i) {
      const Piece& piece = pieces[i];
      if (!(piece.source.least() + y < std::min(best, known))) continue;
      const auto [through, share] = piece.source.cross(x - piece.begin, y);
      if (!(through < best)) continue;
      best = through;
      source = piece.nearest;
      farther = piece.source.farther();
      crossing = piece.begin + share * frame.length * spacing;
    }
    if (!(best < known)) return;
    const double after = std::sqrt((x - crossing) * (x - crossing) + y * y);
    const FaceNorms::Place ray{after > 0.0 ? (x - crossing) / after : 0.0, after > 0.0 ? y / after : 1.0};
    const double cosine = ray[0] * side[0] + ray[1] * side[1];
    if (farther > 0.0 || dearer > 1.0 || side_dearer > 1.0) {
      double radius = refracted_radius(best - after + farther, {ray[0], dearer}, true) + after;
      radius = refracted_radius(radius, {cosine, side_dearer}, false);
      farther = std::clamp(radius - best, 0.0, flattest * best);
    }
    reach(point, best, source, farther, sign * cosine * side_dearer);
  };
  const Index first_side = frame.along ? Mesh::previous_in_face(halfedge) : Mesh::next_in_face(halfedge);
  const Index second_side = frame.along ? Mesh::next_in_face(halfedge) : Mesh::previous_in_face(halfedge);
  const Index apex = mesh().apex(halfedge);
  look(apex, frame.apex_x, frame.apex_y, {1.0, 0.0}, 1.0, 0.0);
  for (const Index side : {first_side, second_side}) {
    const Index other = mesh().edge_of(side);
    const double x = side == first_side ? 0.0 : frame.length;
    const bool from_apex = mesh().edge_vertices(other)[0] == apex;
    const Index first_point = norms_->point(other, 1);
    const double length = mesh().side_length(side);
    const double scale = length > 0.0 ? 1.0 / length : 0.0;
    const FaceNorms::Place along{(frame.apex_x - x) * scale, frame.apex_y * scale};
    const double other_cost = norms_->edge_cost(other);
    const double side_dearer = other_cost > 0.0 ? length / other_cost : 1.0;
    for (Index k = 1; k < last; ++k) {
      const double t = spacing * (from_apex ? last - k : k);  // from the edge to the apex
      look(first_point + k - 1, x + t * (frame.apex_x - x), t * frame.apex_y, along, side_dearer,
           from_apex ? -1.0 : 1.0);
    }
  }
}

}  // namespace vorogeo
