// The file that filters with large results write them to.
#pragma once

#include <filesystem>

#include "host/filter_row.h"

namespace vorogeo::plugin {

/// The parameter matrix_file.
RichFileToWrite output_file_parameter();

/// Where to write, empty for nowhere; refused before a long computation if it is no plain file in a folder
/// that exists, or may not be written. \throw InvalidInput, FileError.
std::filesystem::path output_file(const FilterCall& call);

}  // namespace vorogeo::plugin
