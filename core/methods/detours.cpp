// Which direct geodesics a graph needs: those that no detour over a vertex beside them stands for.
#include <algorithm>
#include <cmath>

#include "methods/window_tree.h"

namespace vorogeo {

namespace {

/// A path of the graph goes round many corners, and only the worst direction between two vertices has the
/// excess that is allowed: the mean excess is that small a part of it.
constexpr double worst_to_mean = 2.25;

}  // namespace

// Adikusuma, Fang, He 2020, section 4, restated: a target at distance D in a direction that differs by the
// small angle t from that of a vertex at distance d is reached over that vertex by a path longer than D by d
// D t^2 / (2 (D - d)). That is at most e D from D = d + d t^2 / (2 e) on. A window lies between the rays to
// two vertices; in the direction where both do worst, the better one of them gives the distance beyond which
// the window need not go.
double WindowTree::greatest_distance(const TreeWindow& window) const {
  const double begin_x = window.begin - window.x;
  const double end_x = window.end - window.x;
  const double angle = std::atan2(end_x, window.y) - std::atan2(begin_x, window.y);
  if (!(angle < 1.57)) return unreachable;
  const double first = window.begin_critical;
  const double second = window.end_critical;
  const double allowed = 2.0 * worst_to_mean * rules_.epsilon;
  const double first_rate = first / allowed;
  const double second_rate = second / allowed;
  // first + first_rate t^2 = second + second_rate (angle - t)^2
  const double b = second_rate * angle;
  const double c = second + second_rate * angle * angle - first;
  double t = angle;
  if (c <= 0.0) {
    t = 0.0;
  } else {
    const double square = b * b + (first_rate - second_rate) * c;
    if (square >= 0.0) t = std::min(angle, c / (b + std::sqrt(square)));
  }
  const double by_first = first + first_rate * t * t;
  const double by_second = second + second_rate * (angle - t) * (angle - t);
  return window.offset + std::max({std::min(by_first, by_second), first, second});
}

bool WindowTree::has_detour(const TreeWindow& window, double apex_x, double apex_y, double direct) const {
  const auto over = [&](double towards, double critical) {
    const double ray_x = towards - window.x;
    const double ray = std::hypot(ray_x, window.y);
    if (!(ray > 0.0)) return unreachable;
    const double vertex_x = window.x + ray_x * (critical / ray);
    const double vertex_y = window.y * (critical / ray - 1.0);
    return critical + std::hypot(apex_x - vertex_x, apex_y - vertex_y);
  };
  const double longest = (1.0 + rules_.epsilon) * direct;
  return over(window.begin, window.begin_critical) <= longest ||
         over(window.end, window.end_critical) <= longest;
}

}  // namespace vorogeo
