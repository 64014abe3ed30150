// Hints to the processor and the compiler; empty where they are unknown.
#pragma once

// ---- Marks a function to be compiled for several instruction sets

// Windows cannot choose between them when it loads a library.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(_WIN32) && !defined(VOROGEO_NO_CLONES)
#define VOROGEO_CLONES __attribute__((target_clones("default", "avx2", "arch=skylake-avx512")))
#else
#define VOROGEO_CLONES
#endif

// ---- Marks a function to be inlined into those

#if defined(__GNUC__)
#define VOROGEO_INLINE inline __attribute__((always_inline))
#else
#define VOROGEO_INLINE inline
#endif

namespace vorogeo {

// ---- A hint that memory will be read soon

inline void prefetch_line([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

}  // namespace vorogeo
