// The container of index files. Layout, little endian: magic (8 bytes), version (u32), byte order mark (u32),
// then blocks: element size (u64), number of elements (u64), checksum of the contents (u64), the contents.
#include "index/index_file.h"

#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace vorogeo {

namespace {

constexpr std::array<char, 8> magic{'V', 'O', 'R', 'O', 'G', 'E', 'O', '\n'};
constexpr std::uint32_t version = 6;
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::uint32_t swapped_byte_order = 0x04030201;

/// The system's reason for a failure; empty unless errno, cleared beforehand, was set: streams do not promise
/// to set it.
std::string reason_of_system() { return errno ? " (" + std::generic_category().message(errno) + ")" : ""; }

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
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + i, 8);
    add(word);
  }
  std::uint64_t last = 0;
  if (i < bytes.size()) std::memcpy(&last, bytes.data() + i, bytes.size() - i);
  add(last);
  return sum ^ (sum >> 32);
}

namespace {

/// Runs a step of the writing; any failure becomes an IndexFileError.
template <class Do>
auto writing(Do&& body) {
  try {
    return body();
  } catch (const InvalidInput& error) {
    throw IndexFileError(error.what());
  } catch (const FileError& error) {
    throw IndexFileError(error.what());
  }
}

}  // namespace

IndexFileWriter::IndexFileWriter(const std::filesystem::path& file)
    : out_(writing([&] { return std::make_unique<OutputFile>(file, "The index file"); })) {
  writing([&] {
    out_->write(std::as_bytes(std::span(magic)));
    for (std::uint32_t number : {version, byte_order})
      out_->write(std::as_bytes(std::span<const std::uint32_t, 1>(&number, 1)));
  });
}

void IndexFileWriter::write(std::span<const std::byte> bytes, std::size_t element_size) {
  const std::array<std::uint64_t, 3> head{element_size, bytes.size() / element_size, block_checksum(bytes)};
  writing([&] {
    out_->write(std::as_bytes(std::span(head)));
    out_->write(bytes);
  });
}

void IndexFileWriter::finish() {
  writing([&] { out_->finish(); });
}

IndexFileReader::IndexFileReader(const std::filesystem::path& file) : file_(file) {
  check_readable(file);
  std::error_code error;
  left_ = std::filesystem::file_size(file, error);
  errno = 0;
  in_.open(file, std::ios::binary);
  if (error || !in_) {
    throw IndexFileError("Cannot open the index file " + file.string() + reason_of_system() +
                         "; check that you may read it.");
  }
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
  read(std::as_writable_bytes(std::span<T, 1>(&value, 1)).first(sizeof(T)));
  return value;
}

void IndexFileReader::fail(const std::string& what) const {
  throw IndexFileError("The index file " + file_.string() + " " + what + "; build the index again.");
}

std::size_t IndexFileReader::next_count(std::size_t element_size) {
  const auto size = number<std::uint64_t>();
  count_ = number<std::uint64_t>();
  if (size != element_size) fail("is damaged (unexpected block)");
  if (left_ < sizeof(std::uint64_t) || count_ > (left_ - sizeof(std::uint64_t)) / element_size)
    fail("is truncated");
  counted_ = true;
  return count_;
}

void IndexFileReader::expect(std::size_t count, std::size_t element_size) {
  if (!counted_) next_count(element_size);
  counted_ = false;
  if (count_ != count) fail("is damaged (a block has the wrong size)");
}

void IndexFileReader::read(std::span<std::byte> bytes) {
  if (bytes.size() > left_) fail("is truncated");
  in_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in_) fail("could not be read");
  left_ -= bytes.size();
}

void IndexFileReader::read_checked(std::span<std::byte> contents) {
  const auto expected = number<std::uint64_t>();
  read(contents);
  if (block_checksum(contents) != expected) fail("is damaged (a checksum does not match)");
}

void IndexFileReader::finish() {
  if (left_ != 0) fail("is damaged (it goes on after its end)");
}

}  // namespace vorogeo
