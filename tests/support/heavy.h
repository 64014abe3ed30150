// Skips tests that are too slow under sanitizers, with a message, or gives them fewer meshes there: what a
// figure on a large mesh says does not depend on sanitizers, and the code that runs is the same on a small
// one.
#pragma once

#include <gtest/gtest.h>

#include <vector>

/// Part of the address sanitizer; nothing where the program is linked without it.
extern "C" void __asan_init() __attribute__((weak));

namespace vorogeo::test {

/// Whether the core of this program is watched by sanitizers, which make it some ten times slower.
inline bool sanitized() { return &__asan_init != nullptr; }

/// All of these cases, under sanitizers only the first.
template <class Case>
std::vector<Case> one_under_sanitizers(std::vector<Case> cases) {
  if (sanitized() && !cases.empty()) cases.erase(cases.begin() + 1, cases.end());
  return cases;
}

}  // namespace vorogeo::test

#define VOROGEO_HEAVY_TEST() \
  if (vorogeo::test::sanitized()) GTEST_SKIP() << "left out under sanitizers: too slow there"
