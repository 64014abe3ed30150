// Reads the available memory from the files in which Linux states it.
#include "support/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>

namespace vorogeo {

namespace {

constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::max();

/// The first number of a file; `unknown` if there is none ("max" in a control group means no limit).
std::int64_t number_in(const char* file) {
  std::ifstream in(file);
  std::int64_t value = 0;
  return in >> value ? value : unknown;
}

std::int64_t system_available() {
  std::ifstream in("/proc/meminfo");
  std::string name;
  std::int64_t kilobytes = 0;
  while (in >> name >> kilobytes) {
    if (name == "MemAvailable:") return kilobytes * 1024;
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return unknown;
}

std::int64_t group_available() {
  const std::int64_t limit = number_in("/sys/fs/cgroup/memory.max");
  const std::int64_t used = number_in("/sys/fs/cgroup/memory.current");
  if (limit == unknown || used == unknown) return unknown;
  return std::max<std::int64_t>(0, limit - used);
}

std::int64_t address_space_available() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknown;
  const std::int64_t used = number_in("/proc/self/statm");
  if (used == unknown) return unknown;
  return std::max<std::int64_t>(0,
                                static_cast<std::int64_t>(limit.rlim_cur) - used * ::sysconf(_SC_PAGESIZE));
}

std::string in_units(double bytes) {
  char text[32];
  if (bytes >= 1 << 30) {
    std::snprintf(text, sizeof text, "%.3g GiB", bytes / (1 << 30));
  } else {
    std::snprintf(text, sizeof text, "%.3g MiB", bytes / (1 << 20));
  }
  return text;
}

}  // namespace

std::int64_t available_memory_bytes() {
  return std::min({system_available(), group_available(), address_space_available()});
}

void require_memory(double needed, std::int64_t max_bytes, const std::string& what,
                    const std::string& advice) {
  const std::int64_t limit = max_bytes > 0 ? max_bytes : available_memory_bytes();
  if (needed <= static_cast<double>(limit)) return;
  throw NotEnoughMemory(what + " takes " + in_units(needed) + ", more than the " +
                        in_units(static_cast<double>(limit)) +
                        (max_bytes > 0 ? " allowed. " : " of memory available. ") + advice);
}

}  // namespace vorogeo
