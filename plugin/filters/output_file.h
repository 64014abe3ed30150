// The file to which filters write large results.
#pragma once

#include <filesystem>

#include "host/filter_row.h"

namespace vorogeo::plugin {

/// The parameter matrix_file.
RichFileToWrite output_file_parameter();

/// Where to write; empty: nowhere. Refused before a long computation if it is not a plain file in an existing
/// folder, or may not be written. \throw InvalidInput, FileError.
std::filesystem::path output_file(const FilterCall& call);

}  // namespace vorogeo::plugin
