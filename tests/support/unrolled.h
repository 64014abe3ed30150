// Helpers for shapes that unroll into the plane.
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "support/shapes.h"

namespace vorogeo::test {

/// A point of the unrolled surface; the shape decides what the two numbers mean.
using Flat = std::array<double, 2>;

/// Where the corners of each face lie in the unrolled surface.
using Layout = std::vector<std::array<Flat, 3>>;

inline double length_between(const Flat& a, const Flat& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// Adds two triangles for the cell with the lower corners a, b and the upper corners c, d.
void add_cell(Soup& soup, Index a, Index b, Index c, Index d, bool rising_diagonal);

/// The soup of plane_grid.
Soup plane_soup(int columns, int rows, double width, double height, double jitter, unsigned seed);

/// Any face at each vertex with the vertex's weights in it: so vertices are located like other points.
std::vector<SurfacePoint> vertices_in_faces(const Soup& soup);

/// Coordinates x and y of the corners.
Layout layout_by_position(const Soup& soup);

/// Shape whose distance is `formula(face of p, p unrolled, face of q, q unrolled)`.
template <class Formula>
Shape unrolled(Soup soup, Layout layout, Formula formula) {
  Shape shape{std::move(soup), {}};
  shape.distance = [at_vertex = vertices_in_faces(shape.soup), layout = std::move(layout), formula](
                       const SurfacePoint& p, const SurfacePoint& q) {
    auto located = [&](const SurfacePoint& point) {
      const SurfacePoint& in_face = point.is_vertex() ? at_vertex[point.vertex] : point;
      Flat flat{};
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 2; ++k) flat[k] += in_face.barycentric[i] * layout[in_face.face][i][k];
      }
      return std::pair{in_face.face, flat};
    };
    const auto [face_p, flat_p] = located(p);
    const auto [face_q, flat_q] = located(q);
    return formula(face_p, flat_p, face_q, flat_q);
  };
  return shape;
}

}  // namespace vorogeo::test
