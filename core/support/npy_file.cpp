// The header of version 1.0 of the format, then the values as they lie in memory.
#include "support/npy_file.h"

#include <bit>
#include <fstream>
#include <string>
#include <system_error>

#include "support/error.h"

namespace vorogeo {

void write_npy(const std::filesystem::path& file, std::size_t rows, std::size_t columns,
               std::span<const double> values) {
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

  std::filesystem::path part = file;
  part += ".part";
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out << start << header;
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size_bytes()));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, file, error);
  if (!out || error) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw Error("The file " + file.string() +
                " cannot be written. Check that its folder exists, may be written to and has room.");
  }
}

}  // namespace vorogeo
