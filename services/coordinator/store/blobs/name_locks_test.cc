#include "services/coordinator/store/blobs/name_locks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace slicefarm::coordinator::name_locks_test {
namespace {

TEST(NameLocks, WhatIsHeldIsHeldOnceAndKeepsNobodyFromTheOthers) {
  NameLocks locks;
  {
    const auto held = locks.Take("a");
    EXPECT_FALSE(locks.TryTake("a"));
    EXPECT_TRUE(locks.TryTake("b"));
  }
  EXPECT_TRUE(locks.TryTake("a"));
}

TEST(NameLocks, OneAtATime) {
  NameLocks locks;
  std::atomic<int> inside = 0;
  std::atomic<bool> together = false;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 1000; ++round) {
        const auto held = locks.Take("a");
        if (++inside > 1) together = true;
        --inside;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_FALSE(together);
}

}  // namespace
}  // namespace slicefarm::coordinator::name_locks_test
