// The compiled extension vorogeo._core: the core behind the Python package, which checks all arguments.
#include <nanobind/nanobind.h>

#include "arrays.h"
#include "errors.h"
#include "mesh_binding.h"
#include "methods_binding.h"
#include "surface_binding.h"
#include "tasks_binding.h"

NB_MODULE(_core, module) {
  module.doc() =
      "The core of VoroGeo; use the functions of the package vorogeo, which check their arguments.";
  vorogeo::python::translate_errors();
  vorogeo::python::bind_mesh_functions(module);
  vorogeo::python::bind_methods(module);
  vorogeo::python::bind_metrics(module);
  vorogeo::python::bind_output(module);
  vorogeo::python::bind_points(module);
  vorogeo::python::bind_surface(module);
  vorogeo::python::bind_tasks(module);
}
