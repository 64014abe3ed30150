// The container of index files. Layout, little endian: magic (8 bytes), version (u32), byte order mark (u32),
// then blocks: element size (u64), number of elements (u64), checksum of the contents (u64), zeros up to a
// multiple of block_alignment, the contents.
#include "index/index_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <system_error>

#include "support/checkpoint.h"

namespace vorogeo {

namespace {

constexpr std::array<char, 8> magic{'V', 'O', 'R', 'O', 'G', 'E', 'O', '\n'};
constexpr std::uint32_t version = 11;
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::uint32_t swapped_byte_order = 0x04030201;

constexpr std::size_t block_head_size = 24;
/// Bytes of a checksum between two checkpoints.
constexpr std::size_t bytes_per_checkpoint = std::size_t{1} << 24;

/// Bytes from a place in a file to the next at which contents may begin.
std::size_t padding_at(std::size_t place) {
  return (block_alignment - place % block_alignment) % block_alignment;
}

/// Only plain files are opened: opening a pipe would wait forever.
void check_readable(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw IndexFileError("There is no index file " + file.string() +
                         "; check the name, or build the index and save it there.");
  }
  if (is_directory(status)) {
    throw IndexFileError("The index file " + file.string() + " is a folder; name a file in it.");
  }
  if (!error && !is_regular_file(status)) {
    throw IndexFileError("The index file " + file.string() + " is a device or a pipe; name a plain file.");
  }
}

}  // namespace

std::uint64_t block_checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = 0x9e3779b97f4a7c15ull ^ bytes.size();
  auto add = [&](std::uint64_t word) {
    sum = (std::rotl(sum, 29) ^ word) * 0xff51afd7ed558ccdull + 0x2545f4914f6cdd1dull;
  };
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    if (i % bytes_per_checkpoint == 0) checkpoint();
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + i, 8);
    add(word);
  }
  std::uint64_t last = 0;
  if (i < bytes.size()) std::memcpy(&last, bytes.data() + i, bytes.size() - i);
  add(last);
  return sum ^ (sum >> 32);
}

void writing_index(const std::function<void()>& step) {
  try {
    step();
  } catch (const InvalidInput& error) {
    throw IndexFileError(error.what());
  } catch (const FileError& error) {
    throw IndexFileError(error.what());
  }
}

SavedIndexBytes::SavedIndexBytes(const std::filesystem::path& file) {
  writing_index([&] { out_ = std::make_unique<OutputFile>(file, "The index file"); });
}

void SavedIndexBytes::write(std::span<const std::byte> bytes) {
  writing_index([&] { out_->write(bytes); });
}

void SavedIndexBytes::finish() {
  writing_index([&] { out_->finish(); });
}

bool begins_as_index(std::string_view head) {
  return head.starts_with(std::string_view(magic.data(), magic.size()));
}

std::uint64_t BlockPlaces::next(std::uint64_t bytes) {
  const std::uint64_t head_end = end_ + block_head_size;
  const std::uint64_t contents = head_end + padding_at(head_end);
  end_ = contents + bytes;
  return contents;
}

IndexFileWriter::IndexFileWriter(IndexBytes& out) : out_(out) {
  out_.write(std::as_bytes(std::span(magic)));
  for (std::uint32_t number : {version, byte_order})
    out_.write(std::as_bytes(std::span<const std::uint32_t, 1>(&number, 1)));
}

void IndexFileWriter::write(std::span<const std::byte> bytes, std::size_t element_size) {
  const std::array<std::uint64_t, 3> head{element_size, bytes.size() / element_size, block_checksum(bytes)};
  static_assert(sizeof(head) == block_head_size);
  const std::array<std::byte, block_alignment> zeros{};
  const std::uint64_t begin = places_.end() + sizeof(head);
  const std::uint64_t contents = places_.next(bytes.size());
  out_.write(std::as_bytes(std::span(head)));
  out_.write(std::span(zeros).first(contents - begin));
  out_.write(bytes);
}

IndexFileReader::IndexFileReader(const std::filesystem::path& file) : file_(file) {
  check_readable(file);
  try {
    contents_ = std::make_shared<const MappedFile>(file);
  } catch (const std::system_error& error) {
    throw IndexFileError("Cannot open the index file " + file.string() + " (" + error.code().message() +
                         "); check that you may read it.");
  }
  left_ = contents_->bytes();
  const auto found = number<std::array<char, 8>>();
  if (found != magic) throw IndexFileError(file.string() + " is not an index file of VoroGeo.");
  const auto found_version = number<std::uint32_t>();
  const auto found_order = number<std::uint32_t>();
  if (found_order == swapped_byte_order) {
    throw IndexFileError(
        "The index file " + file.string() +
        " was written on a machine of the other byte order; build the index again on this one.");
  }
  if (found_order != byte_order) fail("is damaged (its byte order is none)");
  if (found_version != version) {
    throw IndexFileError("The index file " + file.string() + " has format version " +
                         std::to_string(found_version) + ", this program reads version " +
                         std::to_string(version) + "; build the index again.");
  }
}

template <class T>
T IndexFileReader::number() {
  T value;
  std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
  return value;
}

void IndexFileReader::fail(const std::string& what) const {
  throw IndexFileError("The index file " + file_.string() + " " + what + "; build the index again.");
}

std::size_t IndexFileReader::next_count(std::size_t element_size) {
  const auto size = number<std::uint64_t>();
  count_ = number<std::uint64_t>();
  if (size != element_size) fail("is damaged (unexpected block)");
  if (count_ > left_.size() / element_size) fail("is truncated");
  counted_ = true;
  return count_;
}

void IndexFileReader::expect(std::size_t count, std::size_t element_size) {
  if (!counted_) next_count(element_size);
  counted_ = false;
  if (count_ != count) fail("is damaged (a block has the wrong size)");
}

std::span<const std::byte> IndexFileReader::take(std::size_t bytes) {
  if (bytes > left_.size()) fail("is truncated");
  const auto taken = left_.first(bytes);
  left_ = left_.subspan(bytes);
  return taken;
}

std::span<const std::byte> IndexFileReader::checked(std::size_t bytes) {
  const auto expected = number<std::uint64_t>();
  const auto padding = take(padding_at(end()));
  const bool zeros = std::ranges::all_of(padding, [](std::byte byte) { return byte == std::byte{0}; });
  const auto contents = take(bytes);
  if (!zeros || block_checksum(contents) != expected) fail("is damaged (a checksum does not match)");
  return contents;
}

void IndexFileReader::skip_block() {
  const auto size = number<std::uint64_t>();
  const auto count = number<std::uint64_t>();
  number<std::uint64_t>();  // the checksum
  take(padding_at(end()));
  if (size != 0 && count > left_.size() / size) fail("is truncated");
  take(size * count);
}

void IndexFileReader::finish() {
  if (!left_.empty()) fail("is damaged (it goes on after its end)");
}

}  // namespace vorogeo
