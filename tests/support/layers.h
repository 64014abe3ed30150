// Squares whose faces have costs of their own: in layers, with distances across two of them, and with faces
// of no width.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "exact/weighted_solver.h"
#include "mesh/metric.h"
#include "support/shapes.h"

namespace vorogeo::test {

/// A mesh with a cost for each face, crossed from so many points on each edge.
inline std::shared_ptr<const Mesh> with_costs(const Soup& soup, const std::vector<double>& cost,
                                              Index points = usual_edge_points) {
  return std::make_shared<const Mesh>(soup.positions, soup.faces,
                                      Metric{sides_by_face_cost(soup.positions, soup.faces, cost), points});
}
inline WeightedSolver solver_of(const std::shared_ptr<const Mesh>& mesh) {
  return WeightedSolver(std::make_shared<const FaceNorms>(mesh, mesh->points_per_edge()));
}

/// The unit square, its lower half in 6 x 6 cells and its upper one in 12 x 12: faces without width close the
/// T-junctions between. Every second vertex of the lower side of the upper half is in no face.
inline Soup plane_with_closed_t_junctions() {
  Soup soup;
  auto rows = [&](Index cells, double low) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (Index j = 0; j <= cells; ++j) {
      for (Index i = 0; i <= cells; ++i) {
        soup.positions.push_back({static_cast<double>(i) / cells, low + 0.5 * j / cells, 0});
      }
    }
    for (Index j = 0; j < cells; ++j) {
      for (Index i = 0; i < cells; ++i) {
        const Index at = first + j * (cells + 1) + i;
        soup.faces.push_back({at, at + 1, at + cells + 2});
        soup.faces.push_back({at, at + cells + 2, at + cells + 1});
      }
    }
    return first;
  };
  const Index below = rows(6, 0.0) + 6 * 7;
  const Index above = rows(12, 0.5);
  for (auto& face : soup.faces) {
    for (Index& v : face) {
      if (v >= above && v <= above + 12 && (v - above) % 2 == 0) v = below + (v - above) / 2;
    }
  }
  for (Index i = 0; i < 6; ++i) soup.faces.push_back({below + i, above + 2 * i + 1, below + i + 1});
  return soup;
}

/// The square [0, 2] x [-1, 1] with a cost for each face by the middle of the face.
struct Layers {
  Layers(int cells, const std::function<double(double, double)>& cost, double jitter = 0.0) {
    soup = plane_grid(cells, cells, 2.0, 2.0, jitter, 3).soup;
    for (Point& p : soup.positions) p[1] -= 1.0;
    // Vertices near the border of the layers lie on it.
    for (Point& p : soup.positions) {
      if (std::abs(p[1]) < 0.5 / cells) p[1] = 0.0;
    }
    mesh = make_mesh(soup);
    for (const auto& face : soup.faces) {
      double x = 0.0;
      double y = 0.0;
      for (Index v : face) {
        x += soup.positions[v][0] / 3.0;
        y += soup.positions[v][1] / 3.0;
      }
      costs.push_back(cost(x, y));
    }
  }
  WeightedSolver solver(Index points = 6) const { return solver_of(weighted(points)); }
  /// The mesh with these costs.
  std::shared_ptr<const Mesh> weighted(Index points = 6) const { return with_costs(soup, costs, points); }
  Index nearest(double x, double y) const {
    Index best = 0;
    for (Index v = 1; v < mesh->vertex_count(); ++v) {
      if (distance_between(soup.positions[v], {x, y, 0}) < distance_between(soup.positions[best], {x, y, 0}))
        best = v;
    }
    return best;
  }
  Soup soup;
  std::shared_ptr<const Mesh> mesh;
  std::vector<double> costs;
};

inline double least_of(const std::function<double(double)>& length, double low, double high) {
  for (int i = 0; i < 200; ++i) {  // golden sections would be faster
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    (length(a) < length(b) ? high : low) = length(a) < length(b) ? b : a;
  }
  return length(0.5 * (low + high));
}

/// Two half-planes y > 0 (cost a) and y < 0 (cost b > a) from a point below: through the border by Snell's
/// law; for two points below also along the border, at its cheaper cost.
inline double two_half_planes(const Point& p, const Point& q, double a, double b) {
  auto crossing = [&](double x) {
    return b * std::hypot(p[0] - x, p[1]) + (q[1] > 0.0 ? a : b) * std::hypot(q[0] - x, q[1]);
  };
  if (q[1] > 0.0) return least_of(crossing, -5.0, 7.0);
  const double straight = b * std::hypot(p[0] - q[0], p[1] - q[1]);
  const double slant = a / std::sqrt(b * b - a * a);  // by the critical angle
  const double run = std::abs(p[0] - q[0]) - slant * (std::abs(p[1]) + std::abs(q[1]));
  if (run <= 0.0) return straight;
  return std::min(straight, a * run + (std::abs(p[1]) + std::abs(q[1])) * std::sqrt(1.0 + slant * slant) * b);
}

}  // namespace vorogeo::test
