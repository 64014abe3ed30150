// Arrays between numpy and the core, points of the surface among them.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/mesh_input.h"
#include "mesh/surface_point.h"
#include "support/error.h"

namespace vorogeo::python {

namespace nb = nanobind;

// ---- What the Python package passes in, already checked and converted

template <class T, class Shape>
using ArrayIn = nb::ndarray<const T, Shape, nb::c_contig, nb::device::cpu>;
using IdArray = ArrayIn<Index, nb::shape<-1>>;
using FlagArray = ArrayIn<std::uint8_t, nb::shape<-1>>;
using EdgeArray = ArrayIn<Index, nb::shape<-1, 2>>;
using TangentArray = ArrayIn<double, nb::shape<-1, 2>>;
using FaceArray = ArrayIn<Index, nb::shape<-1, 3>>;
using ValueArray = ArrayIn<double, nb::shape<-1>>;
using VertexArray = ArrayIn<double, nb::shape<-1, 3>>;
using PointArray = ArrayIn<double, nb::shape<3>>;
using TensorArray = ArrayIn<double, nb::shape<-1, 3, 3>>;

/// Memory of the caller, such as an array or a mapped file, in double or single precision.
template <class Entry>
using OutArray = nb::ndarray<Entry, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

template <class T>
std::span<const T> values_of(const ArrayIn<T, nb::shape<-1>>& array) {
  return {array.data(), array.shape(0)};
}

/// The rows of an array whose rows hold `size` values.
template <std::size_t size, class T, class Shape>
std::vector<std::array<T, size>> rows_of(const ArrayIn<T, Shape>& array) {
  std::vector<std::array<T, size>> rows(array.shape(0));
  if (!rows.empty()) std::memcpy(rows.data(), array.data(), rows.size() * sizeof(rows[0]));
  return rows;
}

// ---- What Python gets: arrays that own their values

template <class T>
using Values = nb::ndarray<nb::numpy, T, nb::shape<-1>>;
template <class T, std::size_t size>
using Rows = nb::ndarray<nb::numpy, T, nb::shape<-1, size>>;

/// The values of shape (n), or rows of equal size as shape (n, size); the caller holds the GIL.
template <class Value>
auto to_numpy(std::vector<Value>&& values) {
  auto owned = std::make_unique<std::vector<Value>>(std::move(values));
  void* data = owned->data();
  const std::size_t count = owned->size();
  nb::capsule owner(owned.get(), [](void* p) noexcept { delete static_cast<std::vector<Value>*>(p); });
  owned.release();
  if constexpr (std::is_arithmetic_v<Value>) {
    return Values<Value>(data, {count}, owner);
  } else {
    constexpr std::size_t size = std::tuple_size_v<Value>;
    return Rows<typename Value::value_type, size>(data, {count, size}, owner);
  }
}

// ---- Points of the surface

/// For each point its vertex, or -1 and an input face with three weights. Faces and weights are empty if all
/// points are vertices.
using PointArrays = std::tuple<IdArray, IdArray, VertexArray>;
using OptionalPoints = std::optional<PointArrays>;

/// \throw InvalidInput for a point in a face that does not exist or that the mesh left out.
inline PointList points_from(const Mesh& mesh, const PointArrays& arrays) {
  const auto& [vertex, face, weights] = arrays;
  if (face.shape(0) == 0) return values_of(vertex);
  std::vector<SurfacePoint> points(vertex.shape(0));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<double, 3> own{weights(i, 0), weights(i, 1), weights(i, 2)};
    points[i] = InputMap(mesh).point_in({vertex(i), face(i), own});
  }
  return points;
}

/// Points for Python, filled without the GIL, as InputMap returns them: the vertex or -1, the input face or
/// -1, and the weights in that face.
struct PointColumns {
  std::vector<Index> vertex{};
  std::vector<Index> face{};
  std::vector<std::array<double, 3>> weights{};

  void add(const Mesh& mesh, const SurfacePoint& point) {
    const InputPoint out = InputMap(mesh).point_out(point);
    vertex.push_back(out.vertex);
    face.push_back(out.face);
    weights.push_back(out.weights);
  }
};

/// A part of an answer for Python: a vector becomes an array, points become three, the rest stays as it is.
template <class Part>
auto to_python(Part&& part) {
  return std::move(part);
}
template <class Value>
auto to_python(std::vector<Value>&& values) {
  return to_numpy(std::move(values));
}
inline auto to_python(PointColumns&& points) {
  return std::tuple(to_numpy(std::move(points.vertex)), to_numpy(std::move(points.face)),
                    to_numpy(std::move(points.weights)));
}

}  // namespace vorogeo::python
