// Arrays between numpy and the core, points of the surface among them.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/surface_path.h"
#include "mesh/gaps.h"
#include "mesh/given_points.h"
#include "mesh/mesh.h"
#include "mesh/surface_point.h"
#include "support/error.h"

namespace vorogeo::python {

// ---- Conversions between numpy arrays and the vectors of the core

namespace nb = nanobind;

/// What the Python package passes in, already checked and converted.
using VertexArray = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using FaceArray = nb::ndarray<const Index, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using IdArray = nb::ndarray<const Index, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

using DoubleArray = nb::ndarray<nb::numpy, double, nb::ndim<1>>;
using IndexArray = nb::ndarray<nb::numpy, Index, nb::ndim<1>>;

inline std::vector<Point> points_of(const VertexArray& vertices) {
  std::vector<Point> points(vertices.shape(0));
  const double* value = vertices.data();
  for (Point& point : points) {
    for (double& coordinate : point) coordinate = *value++;
  }
  return points;
}

inline std::vector<std::array<Index, 3>> triangles_of(const FaceArray& faces) {
  std::vector<std::array<Index, 3>> triangles(faces.shape(0));
  const Index* value = faces.data();
  for (auto& triangle : triangles) {
    for (Index& vertex : triangle) vertex = *value++;
  }
  return triangles;
}

/// What FaceSplits holds: ends of lines, faces, given faces, sides.
using SplitArrays = std::tuple<nb::ndarray<const Index, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>,
                               FaceArray, IdArray, VertexArray>;

/// Splits of the faces of a mesh of `vertices` and `given_faces`. \throw InvalidInput for numbers of vertices
/// and faces that do not exist, and for faces without a given face or lengths: a metric may be a user's own.
inline FaceSplits splits_of(const SplitArrays& arrays, std::size_t vertices, std::size_t given_faces) {
  const auto& [middle_of, faces, given_face, sides] = arrays;
  auto require = [](bool holds, const char* part, std::size_t row, const char* wanted) {
    if (holds) return;
    throw InvalidInput("splits." + std::string(part) + ": row " + std::to_string(row) + " is wrong; give " +
                       wanted + ".");
  };
  auto is_below = [](Index number, std::size_t end) {
    return number >= 0 && static_cast<std::size_t>(number) < end;
  };
  for (std::size_t i = 0; i < middle_of.shape(0); ++i) {
    require(is_below(middle_of(i, 0), vertices + i) && is_below(middle_of(i, 1), vertices + i), "middle_of",
            i, "two vertices that come before the one in their middle");
  }
  const std::size_t count = faces.shape(0);
  if (given_face.shape(0) != count || sides.shape(0) != count) {
    throw InvalidInput("splits: has " + std::to_string(count) + " faces, but " +
                       std::to_string(given_face.shape(0)) + " given faces and lengths of " +
                       std::to_string(sides.shape(0)) + "; give one of each for each face.");
  }
  for (std::size_t f = 0; f < count; ++f) {
    for (int i = 0; i < 3; ++i) {
      require(is_below(faces(f, i), vertices + middle_of.shape(0)), "faces", f, "vertices given or added");
    }
    require(is_below(given_face(f), given_faces) && (f == 0 || given_face(f - 1) <= given_face(f)),
            "given_face", f, "numbers of the faces given, in ascending order");
  }
  FaceSplits splits;
  for (std::size_t i = 0; i < middle_of.shape(0); ++i) {
    splits.middle_of.push_back({middle_of(i, 0), middle_of(i, 1)});
  }
  splits.faces = triangles_of(faces);
  splits.given_face.assign(given_face.data(), given_face.data() + given_face.shape(0));
  splits.sides = points_of(sides);
  return splits;
}

/// Lengths of the sides of the faces, each opposite its corner, with the number of points on each edge where
/// its faces may disagree (0: they agree), and the faces that are split; nothing for lengths in space.
using SideArray = std::optional<std::tuple<VertexArray, Index, std::optional<SplitArrays>>>;

/// The mesh that is measured on.
inline std::shared_ptr<const Mesh> mesh_of(const VertexArray& vertices, const FaceArray& faces,
                                           const SideArray& sides, const GapLimit& gap = {}) {
  if (!sides) return measured_mesh(points_of(vertices), triangles_of(faces), {}, gap);
  const auto& [lengths, points_per_edge, splits] = *sides;
  return measured_mesh(points_of(vertices), triangles_of(faces), points_of(lengths), gap, points_per_edge,
                       splits ? splits_of(*splits, vertices.shape(0), faces.shape(0)) : FaceSplits{});
}

inline std::span<const Index> ids_of(const IdArray& ids) { return {ids.data(), ids.shape(0)}; }

/// A numpy array that owns the values; the caller holds the GIL.
template <class T>
nb::ndarray<nb::numpy, T, nb::ndim<1>> to_numpy(std::vector<T>&& values) {
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  T* data = owned->data();
  const std::size_t size = owned->size();
  nb::capsule owner(owned.get(), [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  owned.release();
  return nb::ndarray<nb::numpy, T, nb::ndim<1>>(data, {size}, owner);
}

/// Rows of equal size as one flat array; Python reshapes it.
template <class T, std::size_t size>
nb::ndarray<nb::numpy, T, nb::ndim<1>> flattened(const std::vector<std::array<T, size>>& rows) {
  std::vector<T> values;
  values.reserve(rows.size() * size);
  for (const auto& row : rows) values.insert(values.end(), row.begin(), row.end());
  return to_numpy(std::move(values));
}

/// Values of all vertices without those of vertices that splits of faces have added.
template <class T>
nb::ndarray<nb::numpy, T, nb::ndim<1>> of_given_vertices(const Mesh& mesh, std::vector<T>&& values) {
  values.resize(mesh.given_vertex_count());
  return to_numpy(std::move(values));
}

// ---- Conversions between surface points in Python and in the core

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

// ---- Paths as arrays for Python

/// Collects paths: lengths, certified, where the points of each path begin, positions, vertices, faces,
/// weights, and which points begin a step over a gap.
class PathArrays {
 public:
  explicit PathArrays(const Mesh& mesh) : mesh_(mesh) {}

  void add(const SurfacePath& path, bool certified) {
    lengths_.push_back(path.length);
    certified_.push_back(certified ? 1 : 0);
    for (const SurfacePoint& point : path.points) {
      for (double coordinate : position_of(mesh_, point)) positions_.push_back(coordinate);
      rows_.add(mesh_, point);
    }
    for (const bool over : steps_over_gaps(mesh_, path.points)) over_gap_.push_back(over ? 1 : 0);
    begin_.push_back(static_cast<std::int64_t>(rows_.vertex.size()));
  }

  nb::tuple take() {
    return nb::make_tuple(to_numpy(std::move(lengths_)), to_numpy(std::move(certified_)),
                          to_numpy(std::move(begin_)), to_numpy(std::move(positions_)),
                          to_numpy(std::move(rows_.vertex)), to_numpy(std::move(rows_.face)),
                          to_numpy(std::move(rows_.weights)), to_numpy(std::move(over_gap_)));
  }

 private:
  const Mesh& mesh_;
  std::vector<double> lengths_;
  std::vector<Index> certified_;
  std::vector<std::int64_t> begin_{0};
  std::vector<double> positions_;
  PointRows rows_;
  std::vector<Index> over_gap_;
};

}  // namespace vorogeo::python
