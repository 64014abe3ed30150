// The compiled extension vorogeo._core: the core behind the Python package, which checks all arguments.
#include "bindings.h"
#include "support/error.h"
#include "support/file.h"
#include "support/memory.h"

namespace vorogeo::python {

namespace {

/// Raises the class of this name in vorogeo.errors.
void raise(const char* name, const char* sentence) {
  PyErr_SetString(nb::module_::import_("vorogeo.errors").attr(name).ptr(), sentence);
}

void translate(const std::exception_ptr& exception, void*) {
  try {
    std::rethrow_exception(exception);
  } catch (const InvalidInput& e) {
    raise("InvalidInput", e.what());
  } catch (const IndexFileError& e) {
    raise("IndexFileError", e.what());
  } catch (const FileError& e) {
    raise("FileError", e.what());
  } catch (const Cancelled& e) {
    raise("Cancelled", e.what());
  } catch (const NotEnoughMemory& e) {
    raise("NotEnoughMemory", e.what());
  } catch (const Error& e) {
    raise("Error", e.what());
  } catch (const std::bad_alloc&) {
    raise("NotEnoughMemory", out_of_memory_sentence);
  }
}

}  // namespace

}  // namespace vorogeo::python

NB_MODULE(_core, module) {
  using namespace vorogeo::python;
  module.doc() =
      "The core of VoroGeo; use the functions of the package vorogeo, which check their arguments.";
  nb::register_exception_translator(translate);
  nb::class_<PythonMesh> mesh(module, "Mesh");
  nb::class_<PythonSurface> surface(module, "Surface");
  bind_mesh(mesh, module);
  bind_methods(mesh, module);
  bind_surface(mesh, surface);
  bind_tasks(surface);
  bind_output(module);
}
