// Turns the errors of the core into those of the Python package.
#include "errors.h"

#include "support/error.h"
#include "support/file.h"
#include "support/memory.h"

namespace vorogeo::python {

namespace {

/// The exception classes; they live as long as the interpreter.
struct Classes {
  nb::handle error, invalid_input, file, index_file, cancelled, not_enough_memory;
};

Classes classes;

void translate(const std::exception_ptr& exception, void*) {
  try {
    std::rethrow_exception(exception);
  } catch (const InvalidInput& e) {
    PyErr_SetString(classes.invalid_input.ptr(), e.what());
  } catch (const IndexFileError& e) {
    PyErr_SetString(classes.index_file.ptr(), e.what());
  } catch (const FileError& e) {
    PyErr_SetString(classes.file.ptr(), e.what());
  } catch (const Cancelled& e) {
    PyErr_SetString(classes.cancelled.ptr(), e.what());
  } catch (const NotEnoughMemory& e) {
    PyErr_SetString(classes.not_enough_memory.ptr(), e.what());
  } catch (const Error& e) {
    PyErr_SetString(classes.error.ptr(), e.what());
  } catch (const std::bad_alloc&) {
    PyErr_SetString(classes.not_enough_memory.ptr(), out_of_memory_sentence);
  }
}

}  // namespace

void translate_errors() {
  nb::module_ errors = nb::module_::import_("vorogeo.errors");
  auto take = [&](const char* name) { return nb::object(errors.attr(name)).release(); };
  classes = {take("Error"),          take("InvalidInput"), take("FileError"),
             take("IndexFileError"), take("Cancelled"),    take("NotEnoughMemory")};
  nb::register_exception_translator(translate);
}

}  // namespace vorogeo::python
