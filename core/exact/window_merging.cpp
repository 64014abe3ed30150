// One window for several neighbouring ones, where it deviates little from them.
#include <algorithm>
#include <cmath>

#include "exact/solver_state.h"

namespace vorogeo {

namespace {

/// The window with the distances of `a` where that begins and of `b` where that ends, whose rays stay between
/// those of the two. False if there is none.
bool merge(const Window& a, const Window& b, Window& result) {
  const double at_begin = a.distance(a.begin);
  const double at_end = b.distance(b.end);
  const double width = b.end - a.begin;
  const double rise = at_end - at_begin;
  const double slope = rise / width;
  const double room = 0.5 * (width - slope * rise);  // (width^2 - rise^2) / (2 width)
  const double radius_at_begin = at_begin - a.offset;
  const double radius_at_end = at_end - b.offset;
  if (!(room > 0.0 && radius_at_begin > 0.0 && radius_at_end > 0.0)) return false;
  // Distance of the new pseudo-source from the beginning. A smaller one turns the rays at both ends outwards,
  // which must stay between those of the old windows.
  const double slope_at_begin = (a.begin - a.source_x) / radius_at_begin;
  const double slope_at_end = (b.end - b.source_x) / radius_at_end;
  double radius = std::max(radius_at_begin, radius_at_end - rise);
  if (slope > slope_at_begin) radius = std::min(radius, room / (slope - slope_at_begin));
  if (slope_at_end > slope) radius = std::min(radius, room / (slope_at_end - slope) - rise);
  const double along = room - radius * slope;
  const double square = (radius - along) * (radius + along);
  const double offset = at_begin - radius;
  if (!(radius > 0.0 && radius + rise > 0.0 && square > 0.0 && offset >= 0.0)) return false;
  result = a;
  result.end = b.end;
  result.source_x = a.begin + along;
  result.source_y = std::sqrt(square);
  result.offset = offset;
  return true;
}

/// Largest deviation of `merged` from `a` and `b`, where they meet and halfway to their other ends.
double deviation(const Window& merged, const Window& a, const Window& b) {
  const double in_a = 0.5 * (a.begin + a.end);
  const double in_b = 0.5 * (b.begin + b.end);
  return std::max({std::abs(merged.distance(in_a) - a.distance(in_a)),
                   std::abs(merged.distance(b.begin) - b.distance(b.begin)),
                   std::abs(merged.distance(in_b) - b.distance(in_b))});
}

}  // namespace

void ExactSolver::State::merge_crossing(Index edge) {
  const double length = mesh.edge_length(edge);
  // Windows travel on from long faces to short ones, whose edges may be shorter than the tolerance on a long
  // edge; and long edges lead into parts that are smaller altogether, where the distance itself bounds it.
  const double tolerance = merge_tolerance * std::min(length, mesh.typical_edge_length());
  // Far out on a long edge, the distances have not the digits from which a pseudo-source could be made again:
  // around an outlier a window would get nearer by rounding each time round, without end.
  const bool is_long = geometry->is_long(edge);
  const double greatest_end =
      is_long ? ExactGeometry::long_beside_small * geometry->fineness[edge] : unreachable;
  std::size_t last = 0;
  double deviated = 0.0;  // largest deviation from the windows that the last one replaces
  for (std::size_t i = 1; i < crossing.size(); ++i) {
    const Window& next = crossing[i].window;
    Window& window = crossing[last].window;
    Window merged;
    const double end_rounding =
        1e-9 * geometry->scale_at(edge, window.end, window.offset + window.source_y, length);
    if (next.end <= greatest_end && next.source == window.source && next.came_from == window.came_from &&
        std::abs(next.begin - window.end) <= end_rounding && merge(window, next, merged)) {
      const double sum = deviated + deviation(merged, window, next);
      if (sum <= tolerance &&
          sum <= merge_tolerance * std::min(window.least_distance(), next.least_distance())) {
        window = merged;
        deviated = sum;
        continue;
      }
    }
    deviated = 0.0;
    crossing[++last] = crossing[i];
  }
  crossing.resize(last + 1);
}

}  // namespace vorogeo
