#pragma once

#include <ctime>

namespace slicefarm::bench {

/// Returns the CPU time of this thread, which depends less on other load of the machine.
inline double ThreadSeconds() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace slicefarm::bench
