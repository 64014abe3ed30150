// Points of lines, looked up by the element of the mesh on which they lie.
#include "tasks/surface_lines.h"

#include <cmath>
#include <utility>

namespace vorogeo {

double SurfaceLines::length() const {
  double sum = 0.0;
  for (const auto& [a, b] : segments) {
    const Point& p = points[a];
    const Point& q = points[b];
    sum += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  }
  return sum;
}

Index LineBuilder::point(const Key& key, const Point& position) {
  const auto [place, is_new] = point_of_.try_emplace(key, static_cast<Index>(lines_.points.size()));
  if (is_new) lines_.points.push_back(position);
  return place->second;
}

Index LineBuilder::at_vertex(Index vertex, std::uint64_t line) {
  return point({vertex, line}, mesh_.position(vertex));
}

Index LineBuilder::on_edge(Index edge, double t, std::uint64_t line) {
  const auto [a, b] = mesh_.edge_vertices(edge);
  if (!(t > 0.0)) return at_vertex(a, line);
  if (t >= 1.0) return at_vertex(b, line);
  const Point& p = mesh_.position(a);
  const Point& q = mesh_.position(b);
  Point position{};
  for (int i = 0; i < 3; ++i) position[i] = (1.0 - t) * p[i] + t * q[i];
  return point({std::int64_t{mesh_.vertex_count()} + edge, line}, position);
}

Index LineBuilder::in_face(Index face, const std::array<double, 3>& barycentric, std::uint64_t corner) {
  Point position{};
  for (int c = 0; c < 3; ++c) {
    const Point& p = mesh_.position(mesh_.face_vertices(face)[c]);
    for (int i = 0; i < 3; ++i) position[i] += barycentric[c] * p[i];
  }
  return point({-1 - std::int64_t{face}, corner}, position);
}

bool LineBuilder::add_segment(Index a, Index b) {
  if (a == b) return false;
  if (a > b) std::swap(a, b);
  const auto number = static_cast<Index>(lines_.segments.size());
  if (!segment_of_.try_emplace({a, static_cast<std::uint64_t>(b)}, number).second) return false;
  lines_.segments.push_back({a, b});
  return true;
}

}  // namespace vorogeo
