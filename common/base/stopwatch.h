#pragma once

#include <chrono>

namespace slicefarm {

/// Timer that measures the seconds since its construction with a monotonic clock. Times are used in
/// reports, and to decide when slow work is started a second time on another worker. They never
/// change a result.
class Stopwatch {
 public:
  double Seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Returns the result of `work()` and adds its duration to `seconds`.
template <typename Work>
auto Timed(double& seconds, const Work& work) {
  const Stopwatch watch;
  auto result = work();
  seconds += watch.Seconds();
  return result;
}

}  // namespace slicefarm
