// The class _core.Method and the list of all methods.
#include <nanobind/stl/map.h>

#include <memory>

#include "bindings.h"
#include "methods/method.h"

namespace vorogeo::python {

namespace {

/// A prepared method and its mesh; one call at a time.
struct BoundMethod {
  std::shared_ptr<const Mesh> mesh;
  std::unique_ptr<GeodesicMethod> method;
};

BoundMethod prepare(const PythonMesh& self, const std::string& name, const MethodOptions& options,
                    nb::object progress) {
  ProgressBridge bridge(progress);
  return {self.mesh, bridge.run([&](const Progress& report) {
            return prepare_method(name, self.mesh, options, report);
          })};
}

Values<double> field(BoundMethod& self, const IdArray& sources) {
  ProgressBridge bridge{nb::none()};
  return to_numpy(bridge.run([&](const Progress& progress) {
    return InputMap(*self.mesh).of_vertices(self.method->field(values_of(sources), progress));
  }));
}

double pair(BoundMethod& self, Index source, Index target) {
  nb::gil_scoped_release release;
  return self.method->pair(source, target);
}

/// For each method, the fields of vorogeo.MethodInfo.
nb::list describe() {
  nb::list rows;
  for (const MethodEntry& entry : all_methods()) {
    const MethodInfo& info = entry.info;
    nb::dict options;
    for (const MethodOption& option : info.options) {
      options[option.name.c_str()] =
          nb::make_tuple(option.standard, option.least, option.greatest, option.whole, option.meaning);
    }
    const MethodClaims& claims = info.claims;
    rows.append(nb::make_tuple(
        info.name, info.title, info.paper, options,
        nb::make_tuple(claims.sources, claims.reuse, claims.bound, claims.metrics, claims.growth), info.exact,
        info.has_pairs));
  }
  return rows;
}

}  // namespace

void bind_methods(nb::class_<PythonMesh>& mesh, nb::module_& module) {
  nb::class_<BoundMethod>(module, "Method")
      .def("field", &field)
      .def("pair", &pair)
      .def("bytes", [](const BoundMethod& self) { return self.method->bytes(); });
  mesh.def("prepare_method", &prepare, nb::arg("name"), nb::arg("options"), nb::arg("progress").none());
  mesh.def("method_warning",
           [](const PythonMesh& self, const std::string& name) { return warning_of(name, *self.mesh); });
  module.def("describe_methods", &describe);
}

}  // namespace vorogeo::python
