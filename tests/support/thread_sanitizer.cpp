// What the thread sanitizer does not know by itself; for the program core_tests_threads only.
#include <pthread.h>
#include <time.h>

/// std::timed_mutex::try_lock_for calls it, but the libtsan of GCC 12 follows pthread_mutex_timedlock only:
/// it would take the mutex (Surface::build_mutex_) for unlocked, and its unlocking for one too many.
extern "C" int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock,
                                       const timespec* until) noexcept {
  constexpr long second = 1'000'000'000;
  timespec now{};
  timespec end{};
  clock_gettime(clock, &now);
  clock_gettime(CLOCK_REALTIME, &end);
  const long nanoseconds = end.tv_nsec + until->tv_nsec - now.tv_nsec + second;
  end.tv_sec += until->tv_sec - now.tv_sec - 1 + nanoseconds / second;
  end.tv_nsec = nanoseconds % second;
  return pthread_mutex_timedlock(mutex, &end);
}
