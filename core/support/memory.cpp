// The error for a result that takes more memory than there is.
#include "support/memory.h"

#include <cstdio>

namespace vorogeo {

namespace {

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

void require_memory(double needed, std::int64_t max_bytes, const std::string& what,
                    const std::string& advice) {
  const std::int64_t limit = max_bytes > 0 ? max_bytes : available_memory_bytes();
  if (needed <= static_cast<double>(limit)) return;
  throw NotEnoughMemory(what + " takes " + in_units(needed) + ", more than the " +
                        in_units(static_cast<double>(limit)) +
                        (max_bytes > 0 ? " allowed. " : " of memory available. ") + advice);
}

}  // namespace vorogeo
