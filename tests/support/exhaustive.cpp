// Unfolding of all straight segments out of a point, then shortest chains.
#include "support/exhaustive.h"

#include <algorithm>
#include <cmath>

#include "support/unrolled.h"

namespace vorogeo::test {

namespace {

double cross(const Flat& a, const Flat& b) { return a[0] * b[1] - a[1] * b[0]; }

double length(const Flat& a) { return std::hypot(a[0], a[1]); }

/// Sine of the angle from ray a to ray b.
double sine_between(const Flat& a, const Flat& b) { return cross(a, b) / (length(a) * length(b)); }

/// Rays closer than this are one ray.
constexpr double same_ray = 1e-13;

/// The third corner of a face over the laid-out edge p q, on the side away from the origin (p to its right).
Flat laid_out(const Flat& p, const Flat& q, double to_p, double to_q, double edge, double area) {
  const double along = (edge * edge + (to_p - to_q) * (to_p + to_q)) / (2.0 * edge);
  const double up = 2.0 * area / edge;
  const Flat e{(q[0] - p[0]) / edge, (q[1] - p[1]) / edge};
  return {p[0] + along * e[0] + up * e[1], p[1] + along * e[1] - up * e[0]};
}

/// Follows a fan of straight lines from the origin across faces and notes the vertices that it meets.
class Segments {
 public:
  Segments(const Mesh& mesh, const std::vector<double>& longest, std::vector<double>& found)
      : mesh_(mesh), found_(found) {
    for (double bound : longest) {
      if (bound != unreachable) farthest_ = std::max(farthest_, bound);
    }
  }

  void note(Index vertex, double distance) { found_[vertex] = std::min(found_[vertex], distance); }

  /// Lines between the rays `low` and `high` leave by `side`, whose ends `right` and `left` lie at p and q.
  void leave(Index side, Index right, const Flat& p, const Flat& q, const Flat& low, const Flat& high) {
    // Opposite rays are not a thin fan: the origin lies on the side, and half of the plane is behind it.
    const double width = sine_between(low, high);
    const bool opposite = low[0] * high[0] + low[1] * high[1] < 0.0 && std::abs(width) <= same_ray;
    if ((width <= same_ray && !opposite) || nearest(p, q) > farthest_) return;
    for (Index h = mesh_.next_around_edge(side); h != side; h = mesh_.next_around_edge(h)) {
      enter(h, right, p, q, low, high);
    }
  }

 private:
  void enter(Index h, Index right, const Flat& p, const Flat& q, const Flat& low, const Flat& high) {
    Index right_side = Mesh::previous_in_face(h);
    Index left_side = Mesh::next_in_face(h);
    if (mesh_.tail(h) != right) std::swap(right_side, left_side);
    auto edge_length = [&](Index side) { return mesh_.edge_length(mesh_.edge_of(side)); };
    const Flat r = laid_out(p, q, edge_length(right_side), edge_length(left_side), edge_length(h),
                            mesh_.face_area(Mesh::face_of(h)));
    const Index apex = mesh_.apex(h);
    if (length(r) == 0.0) return;
    const double from_low = sine_between(low, r);
    const double to_high = sine_between(r, high);
    if (from_low >= -same_ray && to_high >= -same_ray) note(apex, length(r));
    leave(right_side, right, p, r, low, to_high > 0.0 ? r : high);
    leave(left_side, apex, r, q, from_low > 0.0 ? r : low, high);
  }

  static double nearest(const Flat& p, const Flat& q) {
    const Flat d{q[0] - p[0], q[1] - p[1]};
    const double squared = d[0] * d[0] + d[1] * d[1];
    if (squared == 0.0) return length(p);
    const double t = std::clamp(-(p[0] * d[0] + p[1] * d[1]) / squared, 0.0, 1.0);
    return length({p[0] + t * d[0], p[1] + t * d[1]});
  }

  const Mesh& mesh_;
  std::vector<double>& found_;
  double farthest_ = 0.0;
};

using Table = std::vector<std::vector<double>>;

void close_under_chains(Table& table) {
  for (std::size_t k = 0; k < table.size(); ++k) {
    for (std::size_t i = 0; i < table.size(); ++i) {
      if (table[i][k] == unreachable) continue;
      for (std::size_t j = 0; j < table.size(); ++j) {
        table[i][j] = std::min(table[i][j], table[i][k] + table[k][j]);
      }
    }
  }
}

/// Positions of the corners of a face in its own plane.
std::array<Flat, 3> face_plane(const Mesh& mesh, Index face) {
  auto edge_length = [&](int i) { return mesh.edge_length(mesh.edge_of(3 * face + i)); };
  // laid_out puts the third corner to the right of the first edge, so the edge is taken backwards.
  const Flat p{edge_length(0), 0.0};
  const Flat q{0.0, 0.0};
  return {q, p, laid_out(p, q, edge_length(1), edge_length(2), edge_length(0), mesh.face_area(face))};
}

}  // namespace

ExhaustiveGeodesics::ExhaustiveGeodesics(const Mesh& mesh) : mesh_(mesh) {
  const Index n = mesh.vertex_count();
  table_.assign(n, std::vector<double>(n, unreachable));
  for (Index v = 0; v < n; ++v) table_[v][v] = 0.0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    table_[a][b] = table_[b][a] = mesh.edge_length(e);
  }
  Table along_edges = table_;
  close_under_chains(along_edges);
  for (Index v = 0; v < n; ++v) {
    Segments segments(mesh, along_edges[v], table_[v]);
    for (Index h : mesh.corners(v)) {
      const double angle = mesh.corner_angle(h);
      const double right = mesh.edge_length(mesh.edge_of(h));
      const double left = mesh.edge_length(mesh.edge_of(Mesh::previous_in_face(h)));
      if (right == 0.0 || left == 0.0) continue;
      const Flat p{right, 0.0};
      const Flat q{left * std::cos(angle), left * std::sin(angle)};
      segments.leave(Mesh::next_in_face(h), mesh.head(h), p, q, p, q);
    }
  }
  close_under_chains(table_);
}

std::vector<double> ExhaustiveGeodesics::field(const SurfacePoint& source) const {
  if (source.is_vertex()) return table_[source.vertex];
  const auto plane = face_plane(mesh_, source.face);
  const auto& corners = mesh_.face_vertices(source.face);
  std::array<Flat, 3> seen{};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 2; ++k) {
      seen[i][k] = plane[i][k];
      for (int j = 0; j < 3; ++j) seen[i][k] -= source.barycentric[j] * plane[j][k];
    }
  }
  std::vector<double> direct(mesh_.vertex_count(), unreachable);
  std::vector<double> bound(mesh_.vertex_count(), unreachable);
  for (Index v = 0; v < mesh_.vertex_count(); ++v) {
    for (int i = 0; i < 3; ++i) bound[v] = std::min(bound[v], length(seen[i]) + table_[corners[i]][v]);
  }
  Segments segments(mesh_, bound, direct);
  for (int i = 0; i < 3; ++i) {
    segments.note(corners[i], length(seen[i]));
    const int next = (i + 1) % 3;
    if (length(seen[i]) > 0.0 && length(seen[next]) > 0.0) {
      segments.leave(3 * source.face + i, corners[i], seen[i], seen[next], seen[i], seen[next]);
    }
  }
  std::vector<double> result = direct;
  for (Index v = 0; v < mesh_.vertex_count(); ++v) {
    for (Index w = 0; w < mesh_.vertex_count(); ++w)
      result[v] = std::min(result[v], direct[w] + table_[w][v]);
  }
  return result;
}

}  // namespace vorogeo::test
