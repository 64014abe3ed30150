// A tree of the vertices with enough angle, searched around each edge.
#include "index/near_saddles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// In roots of the area of a patch: saddle vertices nearer to a border edge than this make its pieces
/// shorter, by the root of their distance over this.
constexpr double saddle_reach = 0.06;
/// No piece gets shorter than this part.
constexpr double finest_part = 1.0 / 3.0;
/// Enough to know how near they are where thousands crowd.
constexpr int max_saddles = 1000;

/// Angle at a vertex beyond that of a straight path on both sides.
double angle_beyond(const Mesh& mesh, Index vertex) {
  return mesh.total_angle(vertex) - (mesh.is_border(vertex) ? 1.0 : 2.0) * std::numbers::pi;
}

double distance_from_segment(const Point& point, const Point& a, const Point& b) {
  double along = 0.0;
  double square = 0.0;
  for (int k = 0; k < 3; ++k) {
    along += (point[k] - a[k]) * (b[k] - a[k]);
    square += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double t = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  return distance_between(point,
                          {std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), std::lerp(a[2], b[2], t)});
}

std::vector<Box> boxes_of(const Mesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Box> boxes;
  for (Index v : vertices) boxes.push_back({mesh.position(v), mesh.position(v)});
  return boxes;
}

std::vector<Index> saddles_of(const Mesh& mesh, double least_angle) {
  std::vector<Index> found;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (v % elements_per_checkpoint == 0) checkpoint();
    const bool has_place = std::isfinite(mesh.position(v)[0]) && !mesh.corners(v).empty();
    if (has_place && angle_beyond(mesh, v) > least_angle) found.push_back(v);
  }
  return found;
}

}  // namespace

NearSaddles::NearSaddles(const Mesh& mesh, double longest)
    : mesh_(mesh), vertex_(saddles_of(mesh, longest / saddle_reach)), tree_(boxes_of(mesh, vertex_)) {
  for (Index v : vertex_) least_.push_back(longest / saddle_reach / angle_beyond(mesh, v));
}

double NearSaddles::piece_factor(Index edge, double size) const {
  const auto [first, second] = mesh_.edge_vertices(edge);
  const Point a = mesh_.position(first);
  const Point b = mesh_.position(second);
  const double straight = distance_between(a, b);
  if (!(straight > 0.0) || vertex_.empty()) return 1.0;
  // In another metric, a length around here is as many times one in space as the edge is.
  const double reach = saddle_reach * size * straight / mesh_.edge_length(edge);
  double factor = 1.0;
  auto look_at = [&](Index item) {
    const Index v = vertex_[item];
    // Copies of the ends, on the other lip of a slit say, are no more in the way than the ends.
    if (mesh_.position(v) != a && mesh_.position(v) != b) {
      const double apart = distance_from_segment(mesh_.position(v), a, b);
      factor = std::min(factor, std::max({std::sqrt(apart / reach), least_[item], finest_part}));
    }
    return reach * factor * factor;
  };
  Box around{a, a};
  around.add({b, b});
  tree_.visit_near(around, reach, max_saddles, look_at, [](Index) { return false; });
  return factor;
}

}  // namespace vorogeo
