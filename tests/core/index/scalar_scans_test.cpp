// The tests of the kernels of the index once more, for those without vector instructions, under another
// namespace.
#include <gtest/gtest.h>

#undef TEST
#define TEST(suite, name) GTEST_TEST(Scalar##suite, name)
#define vorogeo vorogeo_scalar
#include "core/index/scans_test.cpp"
