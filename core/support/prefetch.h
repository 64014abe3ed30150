// A hint that memory will be read soon.
#pragma once

namespace vorogeo {

inline void prefetch_line([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

}  // namespace vorogeo
