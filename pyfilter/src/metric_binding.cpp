// The functions of _core for metrics, without argument checks.
#include "metric_binding.h"

#include "arrays.h"
#include "mesh/metric.h"

namespace vorogeo::python {

namespace {

using ValueArray = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

std::vector<Tensor> tensors_of(const ValueArray& values) {
  std::vector<Tensor> tensors(values.shape(0) / 9);
  const double* value = values.data();
  for (Tensor& tensor : tensors) {
    for (double& entry : tensor) entry = *value++;
  }
  return tensors;
}

/// Lengths, edges shortened, faces split, and the parts of FaceSplits, or None.
nb::tuple as_tuple(const MetricLengths& found) {
  nb::object splits = nb::none();
  if (!found.splits.empty()) {
    splits =
        nb::make_tuple(flattened(found.splits.middle_of), flattened(found.splits.faces),
                       to_numpy(std::vector<Index>(found.splits.given_face)), flattened(found.splits.sides));
  }
  return nb::make_tuple(flattened(found.sides), found.shortened_edges, found.split_faces, splits);
}

nb::tuple by_cost(const VertexArray& vertices, const FaceArray& faces, const ValueArray& cost) {
  return as_tuple(
      lengths_by_cost(points_of(vertices), triangles_of(faces), std::span(cost.data(), cost.shape(0))));
}

nb::tuple by_tensor(const VertexArray& vertices, const FaceArray& faces, const ValueArray& tensors) {
  return as_tuple(lengths_by_tensor(points_of(vertices), triangles_of(faces), tensors_of(tensors)));
}

DoubleArray slope(const VertexArray& vertices, const FaceArray& faces, double x, double y, double z,
                  double penalty) {
  return to_numpy(slope_cost(points_of(vertices), triangles_of(faces), {x, y, z}, penalty));
}

DoubleArray curvature(const VertexArray& vertices, const FaceArray& faces, double weight) {
  return flattened(curvature_tensors(points_of(vertices), triangles_of(faces), weight));
}

}  // namespace

void bind_metrics(nb::module_& module) {
  const nb::arg vertices("vertices"), faces("faces");
  module.def("lengths_by_cost", &by_cost, vertices, faces, nb::arg("cost"));
  module.def("lengths_by_tensor", &by_tensor, vertices, faces, nb::arg("tensors"));
  module.def("slope_cost", &slope, vertices, faces, nb::arg("x"), nb::arg("y"), nb::arg("z"),
             nb::arg("penalty"));
  module.def("curvature_tensors", &curvature, vertices, faces, nb::arg("weight"));
}

}  // namespace vorogeo::python
