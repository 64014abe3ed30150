// Crossing of many faces that have next to no width.
#include <algorithm>
#include <cmath>

#include "weighted/edge_crossing.h"
#include "weighted/weighted_solver.h"

namespace vorogeo {

/// Crosses a face of a thin fan, from a point of a side to those of the other sides: the way runs along
/// whichever of both sides is cheaper and then straight across. It is a real one, from no source placed in
/// the plane: waves that are not quite as flat as they should be would bring distances down by a little in
/// each face of the fan, again and again.
void WeightedSolver::cross_thin(Index halfedge, Index from) {
  const EdgeFrame frame = norms_->frame(halfedge);
  const PointState own = state_[norms_->point(mesh().edge_of(halfedge), from)];
  const Index last = norms_->points_per_edge() + 1;
  const double at = norms_->fraction(from) * frame.length;
  auto rate_of = [](double cost, double length) { return length > 0.0 ? cost / length : 1.0; };
  const double rate = rate_of(norms_->edge_cost(mesh().edge_of(halfedge)), frame.length);
  for (const Index side : {Mesh::next_in_face(halfedge), Mesh::previous_in_face(halfedge)}) {
    const Index other = mesh().edge_of(side);
    const double other_rate = rate_of(norms_->edge_cost(other), mesh().side_length(side));
    const bool from_apex = mesh().edge_vertices(other)[0] == mesh().apex(halfedge);
    const Index base = from_apex ? mesh().edge_vertices(other)[1] : mesh().edge_vertices(other)[0];
    const double begin = base == mesh().edge_vertices(mesh().edge_of(halfedge))[0] ? 0.0 : frame.length;
    const auto [low, high] = std::minmax(begin, frame.apex_x);
    for (Index k = 0; k <= last; ++k) {
      const double x = std::lerp(begin, frame.apex_x, norms_->fraction(from_apex ? last - k : k));
      const double y = frame.apex_y * norms_->fraction(from_apex ? last - k : k);
      double least_rate = 1.0;
      if (x >= 0.0 && x <= frame.length) least_rate = std::min(least_rate, rate);
      if (at >= low && at <= high) least_rate = std::min(least_rate, other_rate);
      const double straight = std::hypot(x - at, y);
      const double distance = own.distance + std::min(straight, least_rate * std::abs(x - at) + y);
      // In the dearer side, a wave of the cheaper one is plane.
      const double farther = other_rate > rate * (1.0 + 1e-9) ? flattest * distance : own.farther();
      reach(norms_->point(other, k), distance, own.source, farther);
    }
  }
}

}  // namespace vorogeo
