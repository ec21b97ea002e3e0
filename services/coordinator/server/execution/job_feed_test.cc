#include "services/coordinator/server/execution/job_feed.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace slicefarm::coordinator::job_feed_test {
namespace {

TEST(JobFeed, TellsThoseWhoWatchTheJob) {
  JobFeed feed;
  int a = 0, b = 0;
  feed.Listen("a", [&] { ++a; });
  const int64_t second = feed.Listen("a", [&] { ++a; });
  feed.Listen("b", [&] { ++b; });
  feed.Changed("a");
  feed.Changed("c");
  EXPECT_EQ(a, 2);
  EXPECT_EQ(b, 0);
  feed.Forget(second);
  feed.Forget(second);
  feed.Changed("a");
  EXPECT_EQ(a, 3);
}

TEST(JobFeed, ClosingTellsAll) {
  JobFeed feed;
  int closed = 0;
  feed.Listen("a", [&] { closed += feed.closed() ? 1 : 0; });
  feed.Listen("b", [&] { closed += feed.closed() ? 1 : 0; });
  feed.Close();
  EXPECT_EQ(closed, 2);
}

TEST(JobFeed, AfterForgetNobodyIsCalled) {
  JobFeed feed;
  std::atomic<bool> over = false;
  std::thread changes([&] {
    while (!over) feed.Changed("a");
  });
  for (int i = 0; i < 1000; ++i) {
    auto alive = std::make_unique<int>(0);
    const int64_t ticket = feed.Listen("a", [&alive] { ++*alive; });
    feed.Forget(ticket);
    alive.reset();
  }
  over = true;
  changes.join();
}

}  // namespace
}  // namespace slicefarm::coordinator::job_feed_test
