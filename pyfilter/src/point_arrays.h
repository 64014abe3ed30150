// Conversions between surface points in Python and in the core.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "arrays.h"
#include "mesh/given_points.h"
#include "mesh/surface_point.h"
#include "support/error.h"

namespace vorogeo::python {

/// The class _core.Points: a vertex each, or -1 and a face (a row of the faces given) with three weights.
/// Faces and weights are empty if all points are vertices.
struct PointArrays {
  IdArray vertex;
  IdArray face;
  VertexArray weights;
};

void bind_points(nb::module_& module);

/// The point with these weights in a row of the faces given. \throw InvalidInput if it was left out.
inline SurfacePoint point_in_row(const Mesh& mesh, Index row, const std::array<double, 3>& weights) {
  const Index first = first_part(mesh, row);
  if (first != no_index) return point_in_given(mesh, first, weights);
  throw InvalidInput("Face " + std::to_string(row) +
                     " does not exist or is left out of the index (it is masked, names a vertex twice or "
                     "repeats a face), so "
                     "no point lies in it.");
}

inline PointList points_from(const Mesh& mesh, const PointArrays& arrays) {
  if (arrays.face.shape(0) == 0) return ids_of(arrays.vertex);
  std::vector<SurfacePoint> points(arrays.vertex.shape(0));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* w = arrays.weights.data() + 3 * i;
    const Index vertex = arrays.vertex.data()[i];
    points[i] = vertex >= 0 ? SurfacePoint::at_vertex(vertex)
                            : point_in_row(mesh, arrays.face.data()[i], {w[0], w[1], w[2]});
  }
  return points;
}

/// Surface points to be returned to Python: the vertex or -1, a row of the faces given, and the weights in
/// it; a vertex is a corner of its first face, or of none (-1). A point over a gap is in no face, either.
struct PointRows {
  std::vector<Index> vertex;
  std::vector<Index> face;
  std::vector<double> weights;

  void add(const Mesh& mesh, const SurfacePoint& point) {
    const bool is_given = point.is_vertex() && point.vertex < mesh.given_vertex_count();
    vertex.push_back(is_given ? point.vertex : no_index);
    face.push_back(no_index);
    weights.resize(weights.size() + 3, 0.0);
    for_each_face_at(mesh, point, [&](Index at, const std::array<double, 3>& there) {
      if (face.back() != no_index || mesh.is_bridge(at)) return;
      face.back() = mesh.input_face(at);
      std::ranges::copy(weights_in_given(mesh, at, there), weights.end() - 3);
    });
  }
};

}  // namespace vorogeo::python
