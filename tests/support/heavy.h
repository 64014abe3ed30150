// Skips tests that are too slow under sanitizers, with a message.
#pragma once

#include <gtest/gtest.h>

/// Part of the address sanitizer; nothing where the program is linked without it.
extern "C" void __asan_init() __attribute__((weak));

namespace vorogeo::test {

/// Whether the core of this program is watched by sanitizers, which make it some ten times slower.
inline bool sanitized() { return &__asan_init != nullptr; }

}  // namespace vorogeo::test

#define VOROGEO_HEAVY_TEST() \
  if (vorogeo::test::sanitized()) GTEST_SKIP() << "left out under sanitizers: too slow there"
