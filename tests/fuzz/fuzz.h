// What the fuzzers share: arguments, clock, report.
#pragma once

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>

namespace vorogeo::test {

/// Calls `attempt(random)` with a fresh seed until the time is up; an exception ends the run and prints the
/// seed. Usage of the program: PROGRAM SECONDS [FIRST_SEED]. With 0 seconds and the seed of a failure it
/// repeats that failure.
template <class Attempt>
int fuzz(int argc, char** argv, Attempt&& attempt) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10.0;
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::atol(argv[2])) : 1;
  const auto start = std::chrono::steady_clock::now();
  unsigned seed = first;
  do {
    std::mt19937 random(seed);
    // Printed before the attempt, as a crash leaves no time afterwards.
    std::printf("\rseed %u ", seed);
    std::fflush(stdout);
    try {
      attempt(random);
    } catch (const std::exception& error) {
      std::printf("\nFAILED with seed %u: %s\n", seed, error.what());
      return 1;
    }
    ++seed;
  } while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < seconds);
  std::printf("\n%u attempts, none failed\n", seed - first);
  return 0;
}

}  // namespace vorogeo::test
