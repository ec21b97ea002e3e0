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
  feed.Listen("a", [&](auto) { ++a; });
  const int64_t second = feed.Listen("a", [&](auto) { ++a; });
  feed.Listen("b", [&](auto) { ++b; });
  feed.Changed("a");
  feed.Changed("c");
  EXPECT_EQ(a, 2);
  EXPECT_EQ(b, 0);
  feed.Forget(second);
  feed.Forget(second);
  feed.Changed("a");
  EXPECT_EQ(a, 3);
}

TEST(JobFeed, KnowsHowFarRunsHaveCome) {
  JobFeed feed;
  std::vector<JobFeed::News> news;
  feed.Listen("a", [&](JobFeed::News what) { news.push_back(what); });
  JobRecord job;
  job.id = "a";
  job.owner_epoch = 2;
  const auto done = [&] {
    JobRecord now = job;
    feed.AddProgress(now);
    return now.layers_done;
  };
  feed.Progressed("a", {2, 1, 9, 4});
  EXPECT_EQ(done(), 0) << "it does not run, as far as the store knows";
  job.state = JobState::kRunning;
  EXPECT_EQ(done(), 4);
  job.owner_epoch = 3;
  EXPECT_EQ(done(), 0) << "that was another run";
  feed.Progressed({"other", {{"a", {3, 1, 9, 5}}, {"b", {1, 1, 1, 1}}}});
  EXPECT_EQ(done(), 5);
  feed.Progressed({"other", {{"a", {3, 1, 9, 5}}}});
  EXPECT_EQ(news, std::vector(2, JobFeed::News::kProgress)) << "nothing is new";
  feed.Progressed({"other", {}});
  EXPECT_EQ(done(), 0);
  EXPECT_EQ(feed.Running().size(), 1u);
  feed.Ended("a", 1);
  EXPECT_EQ(feed.Running().size(), 1u);
  feed.Ended("a", 2);
  EXPECT_EQ(feed.Running().size(), 0u);
}

TEST(JobFeed, ClosingTellsAll) {
  JobFeed feed;
  int closed = 0;
  feed.Listen("a", [&](auto) { closed += feed.closed() ? 1 : 0; });
  feed.Listen("b", [&](auto) { closed += feed.closed() ? 1 : 0; });
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
    const int64_t ticket = feed.Listen("a", [&alive](auto) { ++*alive; });
    feed.Forget(ticket);
    alive.reset();
  }
  over = true;
  changes.join();
}

}  // namespace
}  // namespace slicefarm::coordinator::job_feed_test
