// Normals of vertices, bends of edges, and the principal directions of their sums.
#include "mesh/shape_metrics.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh/sorted_sides.h"
#include "support/error.h"

namespace vorogeo {

namespace {

/// Bends below this, in radians, come from rounding: single precision has 1e-7.
constexpr double flat_bend = 1e-6;

Point cross_of(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot_of(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point step_to(const Point& a, const Point& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }

/// The vector with length 1; zero stays zero.
Point unit_of(const Point& a) {
  const double length = std::hypot(a[0], a[1], a[2]);
  return length > 0.0 ? Point{a[0] / length, a[1] / length, a[2] / length} : Point{};
}

/// Normal of a face, as long as twice its area.
Point face_normal(std::span<const Point> positions, const std::array<Index, 3>& face) {
  return cross_of(step_to(positions[face[0]], positions[face[1]]),
                  step_to(positions[face[0]], positions[face[2]]));
}

/// Sums of the normals of the faces at each vertex, scaled to length 1. Flipped faces would cancel out, so
/// each normal is turned to the side of those before it.
std::vector<Point> vertex_normals(std::span<const Point> positions,
                                  std::span<const std::array<Index, 3>> faces) {
  std::vector<Point> normals(positions.size());
  for (const auto& face : faces) {
    const Point normal = face_normal(positions, face);
    for (Index v : face) {
      const double sign = dot_of(normals[v], normal) < 0.0 ? -1.0 : 1.0;
      for (int k = 0; k < 3; ++k) normals[v][k] += sign * normal[k];
    }
  }
  for (Point& normal : normals) normal = unit_of(normal);
  return normals;
}

/// A symmetric matrix for each vertex: the sum over its inner edges of bend times length, in the direction
/// across the edge.
std::vector<Tensor> bend_tensors(std::span<const Point> positions,
                                 std::span<const std::array<Index, 3>> faces) {
  const std::vector<SideOfFace> sides = sides_in_mesh(faces);
  std::vector<Tensor> sum(positions.size(), Tensor{});
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const auto& [ends, face, corner] = sides[i];
    const auto& [next_ends, next_face, next_corner] = sides[i + 1];
    if (next_ends != ends) continue;
    const auto [a, b] = ends;
    const Point along = step_to(positions[a], positions[b]);
    const Point edge = unit_of(along);
    // Directions in both faces away from the edge: opposite on a plane.
    auto away = [&](Index v) {
      Point aside = step_to(positions[a], positions[v]);
      const double x = dot_of(aside, edge);
      for (int k = 0; k < 3; ++k) aside[k] -= x * edge[k];
      return unit_of(aside);
    };
    const Point left = away(faces[face][corner]);
    const Point right = away(faces[next_face][next_corner]);
    const Point bisector{left[0] + right[0], left[1] + right[1], left[2] + right[2]};
    const Point across = unit_of(step_to(right, left));
    // The sign tells ridges from valleys; which is which does not matter.
    const Point normal = face_normal(positions, faces[face]);
    const double sign = dot_of(bisector, normal) < 0.0 ? -1.0 : 1.0;
    const double bend =
        sign * 2.0 * std::asin(std::min(1.0, 0.5 * std::hypot(bisector[0], bisector[1], bisector[2])));
    if (std::abs(bend) < flat_bend) continue;
    const double weight = bend * std::hypot(along[0], along[1], along[2]);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        sum[a][3 * r + c] += weight * across[r] * across[c];
        sum[b][3 * r + c] += weight * across[r] * across[c];
      }
    }
  }
  return sum;
}

/// Each matrix with those of its neighbours: a single ring of edges has too few directions.
std::vector<Tensor> over_neighbours(const std::vector<Tensor>& of,
                                    std::span<const std::array<Index, 3>> faces) {
  std::vector<Tensor> sum(of);
  for (const auto& face : faces) {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 9; ++k) {
        // In a closed fan every neighbour comes twice.
        sum[face[i]][k] += 0.5 * (of[face[(i + 1) % 3]][k] + of[face[(i + 2) % 3]][k]);
      }
    }
  }
  return sum;
}

}  // namespace

std::vector<double> slope_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                               const Point& up, double penalty) {
  if (!(penalty >= 0.0 && std::isfinite(penalty))) {
    throw InvalidInput("The slope penalty is " + std::to_string(penalty) + "; give a number of at least 0.");
  }
  const Point upwards = unit_of(up);
  if (!(dot_of(upwards, upwards) > 0.5)) {
    throw InvalidInput("The direction upwards has no length; give a vector such as (0, 0, 1).");
  }
  std::vector<double> cost;
  cost.reserve(positions.size());
  for (const Point& normal : vertex_normals(positions, faces)) {
    const Point tilt = cross_of(normal, upwards);
    cost.push_back(1.0 + penalty * std::min(1.0, std::hypot(tilt[0], tilt[1], tilt[2])));
  }
  return cost;
}

std::vector<Tensor> curvature_tensors(std::span<const Point> positions,
                                      std::span<const std::array<Index, 3>> faces, double weight) {
  if (!std::isfinite(weight)) throw InvalidInput("The weight of the curvature is not finite; give a number.");
  const auto normals = vertex_normals(positions, faces);
  const auto bends = over_neighbours(bend_tensors(positions, faces), faces);
  std::vector<Tensor> tensors(positions.size(), Tensor{1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (std::size_t v = 0; v < tensors.size(); ++v) {
    // In the plane of the vertex: two directions across the normal.
    const Point& n = normals[v];
    const Point axis = std::abs(n[0]) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0};
    const Point u = unit_of(cross_of(n, axis));
    const Point w = cross_of(n, u);
    auto entry = [&](const Point& a, const Point& b) {
      double value = 0.0;
      for (int i = 0; i < 9; ++i) value += a[i / 3] * bends[v][i] * b[i % 3];
      return value;
    };
    const double uu = entry(u, u);
    const double ww = entry(w, w);
    const double uw = entry(u, w);
    const double mean = 0.5 * (uu + ww);
    const double spread = std::hypot(0.5 * (uu - ww), uw);
    const double one = std::abs(mean + spread);
    const double two = std::abs(mean - spread);
    if (!(one + two > 0.0)) continue;
    // Direction of the eigenvalue mean + spread; the other one is across.
    double angle = 0.5 * std::atan2(2.0 * uw, uu - ww);
    if ((one < two) != (weight < 0.0)) angle += std::acos(0.0);
    const double strength = std::abs(weight) * std::abs(one - two) / (one + two);
    Point d{};
    for (int k = 0; k < 3; ++k) d[k] = std::cos(angle) * u[k] + std::sin(angle) * w[k];
    for (int i = 0; i < 9; ++i) tensors[v][i] += strength * d[i / 3] * d[i % 3];
  }
  return tensors;
}

}  // namespace vorogeo
