// The class _core.Method and the list of all methods.
#include "methods_binding.h"

#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>

#include <memory>

#include "arrays.h"
#include "methods/method.h"
#include "progress_bridge.h"

namespace vorogeo::python {

namespace {

/// A prepared method and its mesh; one call at a time.
struct BoundMethod {
  std::shared_ptr<const Mesh> mesh;
  std::unique_ptr<GeodesicMethod> method;
};

BoundMethod* prepare(const std::string& name, const VertexArray& vertices, const FaceArray& faces,
                     const SideArray& sides, const MethodOptions& options, nb::handle progress) {
  ProgressBridge bridge{progress};
  return bridge
      .run([&](const Progress& inner) {
        auto mesh = mesh_of(vertices, faces, sides);
        auto method = prepare_method(name, mesh, options, inner);
        return std::make_unique<BoundMethod>(std::move(mesh), std::move(method));
      })
      .release();
}

DoubleArray field(BoundMethod& self, const IdArray& sources) {
  ProgressBridge bridge{nb::none()};
  return of_given_vertices(*self.mesh, bridge.run([&](const Progress& progress) {
    return self.method->field(ids_of(sources), progress);
  }));
}

double pair(BoundMethod& self, Index source, Index target) {
  nb::gil_scoped_release release;
  return self.method->pair(source, target);
}

std::string warning(const std::string& name, const VertexArray& vertices, const FaceArray& faces,
                    const SideArray& sides) {
  const MethodEntry& entry = method_named(name);
  return entry.warning ? entry.warning(*mesh_of(vertices, faces, sides)) : std::string();
}

nb::list describe() {
  nb::list rows;
  for (const MethodEntry& entry : all_methods()) {
    const MethodInfo& info = entry.info;
    nb::list options;
    for (const MethodOption& option : info.options) {
      options.append(nb::make_tuple(option.name, option.standard, option.least, option.greatest, option.whole,
                                    option.meaning));
    }
    nb::dict row;
    row["name"] = info.name;
    row["title"] = info.title;
    row["paper"] = info.paper;
    row["options"] = nb::tuple(options);
    row["claims"] = nb::make_tuple(info.claims.sources, info.claims.reuse, info.claims.bound,
                                   info.claims.metrics, info.claims.growth);
    row["exact"] = info.exact;
    row["has_pairs"] = info.has_pairs;
    row["warns"] = static_cast<bool>(entry.warning);
    rows.append(row);
  }
  return rows;
}

}  // namespace

void bind_methods(nb::module_& module) {
  nb::class_<BoundMethod>(module, "Method")
      .def_static("prepare", &prepare, nb::arg("name"), nb::arg("vertices"), nb::arg("faces"),
                  nb::arg("sides").none(), nb::arg("options"), nb::arg("progress").none())
      .def("field", &field, nb::arg("sources"))
      .def("pair", &pair, nb::arg("source"), nb::arg("target"))
      .def("bytes", [](const BoundMethod& self) { return self.method->bytes(); });
  module.def("describe_methods", &describe);
  module.def("method_warning", &warning, nb::arg("name"), nb::arg("vertices"), nb::arg("faces"),
             nb::arg("sides").none());
}

}  // namespace vorogeo::python
