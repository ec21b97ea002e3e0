#pragma once

#include <ctime>

namespace slicefarm::bench {

/// CPU time of this thread: what else the machine does counts for less.
inline double ThreadSeconds() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace slicefarm::bench
