#include "services/coordinator/server/observe/status_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/server/observe/status_board.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::status_page_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr int64_t kSecondUs = 1'000'000;

CoordinatorStatus Status() {
  CoordinatorStatus status;
  status.name = "c1";
  status.build = "0.1.0 (abc)";
  status.uptime_s = 3 * 86400 + 4 * 3600;
  status.store = "SQLite";
  status.now_us = 1'000 * kSecondUs;
  status.jobs = {{JobState::kSucceeded, 12}, {JobState::kQueued, 3}};
  status.open = {{JobState::kQueued, Priority::kBulk, 3, 875 * kSecondUs}};
  status.runners = {{"w:1", 4, {{"j1", "layers 8 to 15", 2.5}}}};
  status.replicas = {{"slicing", {"s:1", "s:2"}}};
  constexpr uintmax_t kGib = 1 << 30;
  status.disk = {.capacity = 8 * kGib, .free = 2 * kGib, .available = 3 * kGib / 2};
  JobRecord job;
  job.id = "j1";
  job.owner = "c2";
  job.layers_total = 100;
  job.layers_done = 7;
  job.start_us = 990 * kSecondUs;
  status.running = {job};
  status.problems = {{std::chrono::system_clock::from_time_t(0), R"({"msg":"worker failed"})"}};
  return status;
}

TEST(StatusPage, TellsWhatIsGoingOn) {
  EXPECT_THAT(
      StatusPage(Status()),
      AllOf(HasSubstr("<td>c1</td>"), HasSubstr("<td>0.1.0 (abc)</td>"),
            HasSubstr("<td>3 d 4 h</td>"), HasSubstr("<td>SQLite</td>"),
            HasSubstr("<td>1.5 GiB of 8.0 GiB free</td>"),
            HasSubstr("<tr><td>SUCCEEDED</td><td>12</td></tr>"),
            HasSubstr("<tr><td>QUEUED</td><td>bulk</td><td>3</td><td>2 min 5 s</td></tr>"),
            HasSubstr("<td>c2</td><td>7 of 100</td><td>10.0 s</td>"),
            HasSubstr("<tr><td>w:1</td><td>4</td><td>1</td>"),
            HasSubstr("<tr><td>w:1</td><td>j1</td><td>layers 8 to 15</td><td>2.5 s</td></tr>"),
            HasSubstr("<tr><td>slicing</td><td>s:2</td></tr>"),
            HasSubstr("<td>1970-01-01T00:00:00Z</td><td>{&quot;msg&quot;:&quot;worker failed"),
            testing::StartsWith("<!doctype html>"), testing::EndsWith("</html>\n")));
}

TEST(StatusBoard, ShowsTheJobsOfAllTenants) {
  MemoryJobs state;
  MemoryJobStore jobs(state);
  NewJob job;
  job.id = "of-acme";
  job.tenant = "acme";
  ASSERT_TRUE(jobs.Create(job, 1).ok());
  const JobRecord claimed = **jobs.Claim("me", 2, 100);
  ASSERT_TRUE(jobs.Update({job.id, claimed.owner_epoch}, {.state = JobState::kRunning}, 3).ok());
  Dispatcher dispatcher;
  const Fleet fleet(dispatcher);
  const StatusBoard board({.name = "c1",
                           .store = "memory",
                           .state_dir = ".",
                           .jobs = jobs,
                           .fleet = fleet,
                           .stages = {},
                           .log = rpc::JsonLog("test"),
                           .patience = std::chrono::minutes(1)});
  EXPECT_THAT(board.Page(), HasSubstr("of-acme"));
}

TEST(StatusPage, NeedsNothingFromElsewhere) {
  const std::string page = StatusPage(Status());
  EXPECT_THAT(page, AllOf(Not(HasSubstr("http")), Not(HasSubstr("<script")), Not(HasSubstr("src=")),
                          Not(HasSubstr("@import"))));
}

TEST(StatusPage, WhatComesFromOutsideIsText) {
  const std::string evil = "<script>alert('&\"')</script>";
  CoordinatorStatus status = Status();
  status.name = status.store = evil;
  status.store_status = absl::UnavailableError(evil);
  status.running[0].id = status.running[0].owner = status.running[0].tenant = evil;
  status.runners[0].name = status.runners[0].tasks[0].job_id = evil;
  status.replicas = {{evil, {evil}}};
  status.problems[0].text = evil;
  const std::string page = StatusPage(status);
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(&#39;&amp;&quot;&#39;)&lt;/script&gt;"));
}

TEST(StatusPage, AnEmptyFarmIsAPageToo) { EXPECT_THAT(StatusPage({}), HasSubstr("<p>none</p>")); }

}  // namespace
}  // namespace slicefarm::coordinator::status_page_test
