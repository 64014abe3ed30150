// The calls of Windows. Files are shared in all ways, so that they can be renamed and removed while they are
// open, as elsewhere.
#include "support/system.h"

#define NOMINMAX 1
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
// Behind windows.h.
#include <fcntl.h>
#include <io.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <string>
#include <system_error>

#include "support/memory.h"
#include "support/parallel.h"

namespace vorogeo {

namespace system {

namespace fs = std::filesystem;

namespace {

constexpr DWORD shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

HANDLE handle_of(int descriptor) { return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor)); }

/// The last error of this thread, as the errno value of the same meaning.
int last_error() {
  const auto condition = std::system_category().default_error_condition(static_cast<int>(::GetLastError()));
  return condition.category() == std::generic_category() ? condition.value() : EIO;
}

int error_of(BOOL succeeded) { return succeeded ? 0 : last_error(); }

OVERLAPPED place_at(std::uint64_t offset) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32);
  return place;
}

DWORD call_size(std::size_t bytes) { return static_cast<DWORD>(std::min<std::size_t>(bytes, 1u << 30)); }

int set_end(HANDLE file, std::uint64_t bytes) {
  FILE_END_OF_FILE_INFO end{};
  end.EndOfFile.QuadPart = static_cast<LONGLONG>(bytes);
  return error_of(::SetFileInformationByHandle(file, FileEndOfFileInfo, &end, sizeof end));
}

/// A view of all of a file, at a place in memory or anywhere; null and the last error if there can be none.
void* view_of(HANDLE file, bool writable, void* place = nullptr) {
  const HANDLE section =
      ::CreateFileMappingW(file, nullptr, writable ? PAGE_READWRITE : PAGE_READONLY, 0, 0, nullptr);
  if (section == nullptr) return nullptr;
  void* view = ::MapViewOfFileEx(section, writable ? FILE_MAP_WRITE : FILE_MAP_READ, 0, 0, 0, place);
  const DWORD error = ::GetLastError();
  ::CloseHandle(section);
  ::SetLastError(error);
  return view;
}

}  // namespace

int open(const fs::path& file, Opening opening) {
  const bool reading = opening == Opening::reading;
  const DWORD creation = opening == Opening::made               ? CREATE_NEW
                         : opening == Opening::existing_or_made ? OPEN_ALWAYS
                                                                : OPEN_EXISTING;
  const HANDLE handle =
      ::CreateFileW(file.c_str(), reading ? GENERIC_READ : GENERIC_READ | GENERIC_WRITE, shared, nullptr,
                    creation, reading ? 0 : FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return -last_error();
  const int descriptor =
      ::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_BINARY | (reading ? _O_RDONLY : 0));
  if (descriptor >= 0) return descriptor;
  ::CloseHandle(handle);
  return -EMFILE;
}

void close(int descriptor) { ::_close(descriptor); }

bool has_name(int descriptor, const fs::path& name) {
  const HANDLE other = ::CreateFileW(name.c_str(), 0, shared, nullptr, OPEN_EXISTING,
                                     FILE_FLAG_OPEN_REPARSE_POINT | FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (other == INVALID_HANDLE_VALUE) return false;
  BY_HANDLE_FILE_INFORMATION own{};
  BY_HANDLE_FILE_INFORMATION named{};
  const bool known = ::GetFileInformationByHandle(handle_of(descriptor), &own) != 0 &&
                     ::GetFileInformationByHandle(other, &named) != 0;
  ::CloseHandle(other);
  return known && own.dwVolumeSerialNumber == named.dwVolumeSerialNumber &&
         own.nFileIndexHigh == named.nFileIndexHigh && own.nFileIndexLow == named.nFileIndexLow;
}

int lock(int descriptor) {
  // Nobody else can read or write the bytes that are locked: one is chosen that no file has.
  OVERLAPPED place = place_at(std::numeric_limits<std::int64_t>::max() - 1);
  if (::LockFileEx(handle_of(descriptor), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0,
                   &place)) {
    return 0;
  }
  const DWORD error = ::GetLastError();
  return error == ERROR_LOCK_VIOLATION || error == ERROR_IO_PENDING ? EWOULDBLOCK : last_error();
}

std::int64_t size(int descriptor) {
  LARGE_INTEGER bytes{};
  return ::GetFileSizeEx(handle_of(descriptor), &bytes) ? std::int64_t{bytes.QuadPart}
                                                        : -std::int64_t{last_error()};
}

std::int64_t read(int descriptor, std::span<std::byte> bytes, std::uint64_t offset) {
  OVERLAPPED place = place_at(offset);
  DWORD done = 0;
  if (::ReadFile(handle_of(descriptor), bytes.data(), call_size(bytes.size()), &done, &place)) return done;
  return ::GetLastError() == ERROR_HANDLE_EOF ? 0 : -std::int64_t{last_error()};
}

std::int64_t write(int descriptor, std::span<const std::byte> bytes, std::uint64_t offset) {
  OVERLAPPED place = place_at(offset);
  DWORD done = 0;
  if (::WriteFile(handle_of(descriptor), bytes.data(), call_size(bytes.size()), &done, &place)) return done;
  return -std::int64_t{last_error()};
}

int resize(int descriptor, std::uint64_t bytes, std::span<std::byte>& mapped) {
  const HANDLE file = handle_of(descriptor);
  if (bytes >= mapped.size()) return set_end(file, bytes);
  // A file that is mapped cannot be cut: it is mapped anew, to the same place.
  void* place = mapped.data();
  mapped = {};
  ::UnmapViewOfFile(place);
  if (const int error = set_end(file, bytes); error != 0) return error;
  if (view_of(file, true, place) == nullptr) return last_error();
  mapped = {static_cast<std::byte*>(place), static_cast<std::size_t>(bytes)};
  return 0;
}

int sync(int descriptor, std::span<const std::byte> mapped) {
  if (!mapped.empty() && !::FlushViewOfFile(mapped.data(), 0)) return last_error();
  return error_of(::FlushFileBuffers(handle_of(descriptor)));
}

void copy_rights(const fs::path&, int) {}  // a file has the rights that its folder gives

bool is_full(int error) { return error == ENOSPC || error == EFBIG; }

int reserve(int descriptor, std::uint64_t offset, std::uint64_t bytes) {
  // Plain files have no holes: growing a file reserves its space.
  const std::int64_t before = size(descriptor);
  if (before < 0) return static_cast<int>(-before);
  if (offset + bytes <= static_cast<std::uint64_t>(before)) return 0;
  return set_end(handle_of(descriptor), offset + bytes);
}

std::optional<Space> space(int descriptor) {
  FILE_STANDARD_INFO info{};
  std::wstring name(1 << 15, L'\0');
  const HANDLE file = handle_of(descriptor);
  const DWORD length = ::GetFinalPathNameByHandleW(file, name.data(), static_cast<DWORD>(name.size()), 0);
  if (length == 0 || length >= name.size()) return {};
  name.resize(name.rfind(L'\\', length) + 1);
  ULARGE_INTEGER free{};
  if (!::GetFileInformationByHandleEx(file, FileStandardInfo, &info, sizeof info) ||
      !::GetDiskFreeSpaceExW(name.c_str(), &free, nullptr, nullptr)) {
    return {};
  }
  return Space{free.QuadPart, static_cast<std::uint64_t>(info.AllocationSize.QuadPart)};
}

std::span<std::byte> map(int descriptor, std::size_t size, bool writable) {
  void* begin = view_of(handle_of(descriptor), writable);
  if (begin == nullptr) throw std::system_error(last_error(), std::generic_category());
  return {static_cast<std::byte*>(begin), size};
}

void unmap(std::span<const std::byte> mapped) { ::UnmapViewOfFile(mapped.data()); }

void make_read_only(std::span<std::byte> mapped) {
  DWORD before = 0;
  ::VirtualProtect(mapped.data(), mapped.size(), PAGE_READONLY, &before);
}

bool is_device(const fs::path& file) {
  std::wstring name(1 << 15, L'\0');  // "nul", "con" and their like, in any folder
  ::GetFullPathNameW(file.c_str(), static_cast<DWORD>(name.size()), name.data(), nullptr);
  return name.starts_with(L"\\\\.\\");
}

int check_writable(const fs::path& file) {
  const DWORD attributes = ::GetFileAttributesW(file.c_str());
  if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_READONLY) != 0) return EACCES;
  const HANDLE handle =
      ::CreateFileW(file.c_str(), GENERIC_WRITE, shared, nullptr, OPEN_EXISTING, 0, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return last_error();
  ::CloseHandle(handle);
  return 0;
}

int replace(const fs::path& from, const fs::path& to, const fs::path& aside) {
  if (::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING)) return 0;
  const int error = last_error();
  // Windows cannot remove (and so replace) a mapped file, but it can rename it.
  if (!fs::is_regular_file(to) || !::MoveFileExW(to.c_str(), aside.c_str(), 0)) return error;
  if (!::MoveFileExW(from.c_str(), to.c_str(), 0)) {
    ::MoveFileExW(aside.c_str(), to.c_str(), 0);
    return error;
  }
  ::DeleteFileW(aside.c_str());
  return 0;
}

int rename_to_free_name(const fs::path& from, const fs::path& to) {
  return error_of(::MoveFileExW(from.c_str(), to.c_str(), 0));
}

}  // namespace system

// ---- Memory and time

std::int64_t available_memory_bytes() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  if (!::GlobalMemoryStatusEx(&status)) return std::numeric_limits<std::int64_t>::max();
  return static_cast<std::int64_t>(std::min(status.ullAvailPhys, status.ullAvailPageFile));
}

double thread_seconds() {
  FILETIME unused{};
  FILETIME kernel{};
  FILETIME user{};
  ::GetThreadTimes(::GetCurrentThread(), &unused, &unused, &kernel, &user);
  constexpr double ticks_per_second = 1e7;
  const auto ticks = [](const FILETIME& time) { return 0x1p32 * time.dwHighDateTime + time.dwLowDateTime; };
  return (ticks(kernel) + ticks(user)) / ticks_per_second;
}

}  // namespace vorogeo
