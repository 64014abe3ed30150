// Writes a matrix as a .npy file, the format of numpy.save.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "support/file.h"

namespace vorogeo::plugin {

/// A file of rows x columns float64 values, row by row. Its disk space is reserved on construction, before
/// the values are computed if their number is known; an old file stays until the new one is complete.
class NpyFile {
 public:
  /// \throw InvalidInput or FileError if it cannot be written; the message names the file.
  NpyFile(const std::filesystem::path& file, std::size_t rows, std::size_t columns);
  /// Writes all values and puts the file in its place. \throw FileError.
  void finish(std::span<const double> values);

 private:
  OutputFile out_;
};

}  // namespace vorogeo::plugin
