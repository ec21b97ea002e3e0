#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace slicefarm {

/// Calls body(index, worker) once for each index of [0, count), on up to `threads` threads
/// including the calling thread. `worker`: number of the thread, from 0. Any thread may get any
/// index, so results must be stored by index. REQUIRES: body does not throw.
template <typename Body>
void ForEachIndex(int threads, size_t count, Body body) {
  std::atomic<size_t> next = 0;
  const auto work = [&](int worker) {
    for (size_t index = next++; index < count; index = next++) body(index, worker);
  };
  const int workers =
      static_cast<int>(std::min<size_t>(std::max(threads, 1), std::max<size_t>(count, 1)));
  std::vector<std::jthread> others;
  for (int worker = 1; worker < workers; ++worker) others.emplace_back(work, worker);
  work(0);
}

}  // namespace slicefarm
