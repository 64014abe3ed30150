// Reads the layout that core/index/index_file.cpp describes.
#include "support/index_blocks.h"

#include <array>
#include <span>
#include <stdexcept>

#include "index/index_file.h"

namespace vorogeo::test {

namespace {

constexpr std::size_t file_head = 16;
constexpr std::size_t block_head = 24;

/// Where the contents of a block begin whose head begins at `head`.
std::size_t contents_at(std::size_t head) {
  return (head + block_head + block_alignment - 1) / block_alignment * block_alignment;
}

}  // namespace

std::vector<std::size_t> block_boundaries(const std::string& file_bytes) {
  std::vector<std::size_t> boundaries{file_head};
  while (boundaries.back() < file_bytes.size()) {
    const std::size_t at = boundaries.back();
    if (at + block_head > file_bytes.size()) throw std::runtime_error("The index file ends inside a block.");
    std::array<std::uint64_t, 2> head;
    std::memcpy(head.data(), file_bytes.data() + at, sizeof(head));
    boundaries.push_back(contents_at(at) + head[0] * head[1]);
  }
  if (boundaries.back() != file_bytes.size()) throw std::runtime_error("The index file ends inside a block.");
  return boundaries;
}

std::vector<IndexBlock> index_blocks(const std::string& file_bytes) {
  const auto boundaries = block_boundaries(file_bytes);
  std::vector<IndexBlock> blocks;
  for (std::size_t i = 0; i + 1 < boundaries.size(); ++i) {
    IndexBlock block;
    std::memcpy(&block.element_size, file_bytes.data() + boundaries[i], sizeof(block.element_size));
    const std::size_t begin = contents_at(boundaries[i]);
    block.contents = file_bytes.substr(begin, boundaries[i + 1] - begin);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::string with_blocks(const std::string& file_bytes, const std::vector<IndexBlock>& blocks) {
  std::string result = file_bytes.substr(0, file_head);
  for (const IndexBlock& block : blocks) {
    const std::array<std::uint64_t, 3> head{block.element_size, block.count(),
                                            block_checksum(std::as_bytes(std::span(block.contents)))};
    const std::size_t begin = contents_at(result.size());
    result.append(reinterpret_cast<const char*>(head.data()), sizeof(head));
    result.resize(begin, '\0');
    result += block.contents;
  }
  return result;
}

}  // namespace vorogeo::test
