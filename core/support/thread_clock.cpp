// The clock of POSIX for the calling thread.
#include "support/thread_clock.h"

#include <ctime>

namespace vorogeo {

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace vorogeo
