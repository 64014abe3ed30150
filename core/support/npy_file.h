// Writes a matrix as a .npy file, the format of numpy.save.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace vorogeo {

/// Writes rows x columns float64 values, row by row; the file appears whole or not at all.
/// \throw Error if it cannot be written; the message names the file.
void write_npy(const std::filesystem::path& file, std::size_t rows, std::size_t columns,
               std::span<const double> values);

}  // namespace vorogeo
