// The file that filters with large results write them to.
#pragma once

#include <filesystem>

#include "filter_row.h"

namespace vorogeo::plugin {

/// The parameter matrix_file.
RichFileToWrite output_file_parameter();

/// Where to write, empty for nowhere; refused before a long computation if there is no such folder.
/// \throw InvalidInput.
std::filesystem::path output_file(const FilterCall& call);

}  // namespace vorogeo::plugin
