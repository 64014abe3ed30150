// Turns the errors of the core into those of the Python package.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

namespace nb = nanobind;

/// Registers the translation: InvalidInput, IndexFileError, Cancelled, NotEnoughMemory and Error become the
/// classes of the same name in vorogeo.errors. (nanobind itself turns bad_alloc into MemoryError.)
void translate_errors();

}  // namespace vorogeo::python
