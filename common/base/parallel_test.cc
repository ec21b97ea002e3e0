#include "common/base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace slicefarm::parallel_test {
namespace {

TEST(ForEachIndex, VisitsEachOnce) {
  for (const int threads : {-1, 0, 1, 2, 8}) {
    for (const size_t count : {0, 1, 5, 1000}) {
      std::vector<int> visits(count, 0);
      std::atomic<int> highest_worker = 0;
      ForEachIndex(threads, count, [&](size_t index, int worker) {
        ++visits[index];
        int seen = highest_worker;
        while (seen < worker && !highest_worker.compare_exchange_weak(seen, worker)) {
        }
      });
      EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<ptrdiff_t>(count));
      EXPECT_LT(highest_worker, std::max(threads, 1));
    }
  }
}

}  // namespace
}  // namespace slicefarm::parallel_test
