// The header of version 1.0 of the format, then the values as they are in memory.
#include "filters/npy_file.h"

#include <bit>
#include <string>

namespace vorogeo::plugin {

NpyFile::NpyFile(const std::filesystem::path& file, std::size_t rows, std::size_t columns)
    : out_(file, "The file") {
  constexpr std::size_t alignment = 64;
  constexpr std::size_t before_header = 10;
  const char* order = std::endian::native == std::endian::little ? "<" : ">";
  std::string header = std::string("{'descr': '") + order + "f8', 'fortran_order': False, 'shape': (" +
                       std::to_string(rows) + ", " + std::to_string(columns) + "), }";
  while ((before_header + header.size() + 1) % alignment != 0) header += ' ';
  header += '\n';
  std::string start("\x93NUMPY\x01\x00", 8);
  start += static_cast<char>(header.size() % 256);
  start += static_cast<char>(header.size() / 256);
  start += header;
  out_.reserve(start.size() + sizeof(double) * rows * columns);
  out_.write(std::as_bytes(std::span(start)));
}

void NpyFile::finish(std::span<const double> values) {
  out_.write(std::as_bytes(values));
  out_.finish();
}

}  // namespace vorogeo::plugin
