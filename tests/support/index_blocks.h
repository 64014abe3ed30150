// Index files taken apart into their blocks, changed, and put together again with checksums that fit.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace vorogeo::test {

/// One block of an index file: contents without head and checksum.
struct IndexBlock {
  std::uint64_t element_size = 0;
  std::string contents;

  std::uint64_t count() const { return contents.size() / element_size; }
  template <class T>
  T get(std::size_t element) const {
    T value;
    std::memcpy(&value, contents.data() + element * sizeof(T), sizeof(T));
    return value;
  }
  template <class T>
  void set(std::size_t element, T value) {
    std::memcpy(contents.data() + element * sizeof(T), &value, sizeof(T));
  }
};

/// The blocks in the order of the file.
enum IndexBlockName {
  fingerprint,
  delta,
  numbers,
  first_layer,
  second_layer,
  parent,
  second_table,
  first_table,
  transit_table,
  second_scale,
  second_offset,
  first_scale,
  first_offset,
  node_least,
  node_scale,
  arc_begin,
  arcs,
  landmarks
};

/// \throw std::runtime_error if the bytes are not an index file.
std::vector<IndexBlock> index_blocks(const std::string& file_bytes);
/// The file with these blocks, under the head of `file_bytes`.
std::string with_blocks(const std::string& file_bytes, const std::vector<IndexBlock>& blocks);
/// Offsets at which a block begins, and the size of the file.
std::vector<std::size_t> block_boundaries(const std::string& file_bytes);

}  // namespace vorogeo::test
