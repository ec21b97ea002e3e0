#pragma once

#include <chrono>

namespace slicefarm {

/// Seconds since it was made, of a clock that does not run backwards. Times go into reports and decide when work is done
/// twice; they never change a result.
class Stopwatch {
 public:
  double Seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The result of `work()`; the time it takes is added to `seconds`.
template <typename Work>
auto Timed(double& seconds, const Work& work) {
  const Stopwatch watch;
  auto result = work();
  seconds += watch.Seconds();
  return result;
}

}  // namespace slicefarm
