#include "services/coordinator/server/in_flight.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace slicefarm::coordinator {
namespace {

const auto kNever = [] { return false; };

TEST(InFlight, OneAtATime) {
  InFlight in_flight;
  std::atomic<int> inside = 0, most = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 50; ++round) {
        ASSERT_TRUE(in_flight.Enter("same", kNever));
        const InFlight::Turn turn(in_flight, "same");
        most = std::max(most.load(), ++inside);
        --inside;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most, 1);
}

TEST(InFlight, OthersAreNotHeldUp) {
  InFlight in_flight;
  ASSERT_TRUE(in_flight.Enter("a", kNever));
  const InFlight::Turn a(in_flight, "a");
  ASSERT_TRUE(in_flight.Enter("b", kNever));
  const InFlight::Turn b(in_flight, "b");
}

TEST(InFlight, WaitingCanBeGivenUp) {
  InFlight in_flight;
  ASSERT_TRUE(in_flight.Enter("a", kNever));
  const InFlight::Turn turn(in_flight, "a");
  int asked = 0;
  EXPECT_FALSE(in_flight.Enter("a", [&] { return ++asked > 2; }));
}

}  // namespace
}  // namespace slicefarm::coordinator
