// The file a user names for an index.
#pragma once

#include <QString>
#include <filesystem>

namespace vorogeo::plugin {

/// The path as the system writes it; empty if none was named.
std::filesystem::path index_file_name(const QString& name);

/// Finds out before a long build whether the file can be written at all. \throw Error if not.
void check_index_file_can_be_written(const std::filesystem::path& file);

}  // namespace vorogeo::plugin
