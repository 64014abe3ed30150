// What differs between operating systems: open files, and memory mapped to them. Each system has a source of
// its own, which also says how much memory there is (memory.h) and how long a thread has worked (parallel.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace vorogeo::system {

// ---- Open files, by their descriptors. An error is its number in errno; where a function returns an error,
// 0 is none.

enum class Opening {
  reading,  ///< an existing file; all others may be written to, and are not opened through a symbolic link
  existing,
  made,  ///< refused if there is a file of that name
  existing_or_made
};
/// Opens a file, which others may still read, write, rename and remove. \return the descriptor or minus the
/// error.
int open(const std::filesystem::path& file, Opening opening);
void close(int descriptor);
/// Whether a file of that name is the open one.
bool has_name(int descriptor, const std::filesystem::path& name);
/// Locks it for this descriptor, until that is closed. EWOULDBLOCK if another one has it locked.
int lock(int descriptor);

/// \return bytes, or minus the error.
std::int64_t size(int descriptor);
/// \return how many bytes were read or written, or minus the error.
std::int64_t read(int descriptor, std::span<std::byte> bytes, std::uint64_t offset);
std::int64_t write(int descriptor, std::span<const std::byte> bytes, std::uint64_t offset);
/// `mapped` is memory mapped to the whole file, or empty; it stays where it is, and gets shorter if the
/// system asks for that.
int resize(int descriptor, std::uint64_t bytes, std::span<std::byte>& mapped);
/// Waits until what was written, also to mapped memory, is on the disk; reports at checkpoints.
int sync(int descriptor, std::span<const std::byte> mapped);
/// Owner and permissions of one file for another.
void copy_rights(const std::filesystem::path& from, int descriptor);

/// Whether an error says that a disk or a quota is full, or a file as large as it may be.
bool is_full(int error);
/// Takes space for bytes from an offset on; the file grows to hold them.
int reserve(int descriptor, std::uint64_t offset, std::uint64_t bytes);
struct Space {
  std::uint64_t free = 0;   ///< on the disk of a file, for this user
  std::uint64_t taken = 0;  ///< by the file
};
/// Nothing where the system does not say.
std::optional<Space> space(int descriptor);

// ---- Memory mapped to a file

/// Maps all of a file, which is not empty. \throw std::system_error.
std::span<std::byte> map(int descriptor, std::size_t size, bool writable);
void unmap(std::span<const std::byte> mapped);
void make_read_only(std::span<std::byte> mapped);

// ---- Files by their names

/// Whether a name stands for a device on which the system has no file.
bool is_device(const std::filesystem::path& file);
/// Whether this user may write to an existing file.
int check_writable(const std::filesystem::path& file);
/// Renames a file, which replaces one that has that name. Where a mapped file cannot be replaced, it is
/// renamed to `aside`, a free name, and removed with the leftovers once it is no longer mapped.
int replace(const std::filesystem::path& from, const std::filesystem::path& to,
            const std::filesystem::path& aside);
/// Renames a file unless there is one of that name (EEXIST).
int rename_to_free_name(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace vorogeo::system
