// Filters that write matrices and lists of pairs to files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "host/filter_row.h"
#include "support/file.h"

namespace vorogeo::plugin {

// ---- The file to which filters write large results

/// The parameter matrix_file.
RichFileToWrite output_file_parameter();

/// Where to write; empty: nowhere. Refused before a long computation if it is not a plain file in an existing
/// folder, or may not be written. \throw InvalidInput, FileError.
std::filesystem::path output_file(const FilterCall& call);

// ---- Writes a matrix as a .npy file, the format of numpy.save

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
