// Filters for the index: build, describe, save and load.
#pragma once

#include <QString>
#include <filesystem>

namespace vorogeo::plugin {

/// The path in the system's encoding; empty if no file was named.
std::filesystem::path index_file_name(const QString& name);

/// Checks before a long build that the file can be written at all. \throw Error if not.
void check_index_file_can_be_written(const std::filesystem::path& file);

}  // namespace vorogeo::plugin
