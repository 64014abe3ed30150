// Tests that are too slow for the sanitizer build say so there and are skipped.
#pragma once

#include <gtest/gtest.h>

#ifdef VOROGEO_SMALL_TESTS
#define VOROGEO_HEAVY_TEST() GTEST_SKIP() << "left out of the sanitizer build: too slow there"
#else
#define VOROGEO_HEAVY_TEST() static_cast<void>(0)
#endif
