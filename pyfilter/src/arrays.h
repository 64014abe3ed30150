// Conversions between numpy arrays and the vectors of the core.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh/gaps.h"
#include "mesh/mesh.h"
#include "support/error.h"

namespace vorogeo::python {

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

}  // namespace vorogeo::python
