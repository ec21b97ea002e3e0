#include "tests/load/generator/algo/run_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::load::run_log_test {
namespace {

using testing::ElementsAre;
using testing::Pair;

Outcome Exhausted(bool says_when) {
  return {.status = MakeError(absl::StatusCode::kResourceExhausted, Reason::kOverloaded, "full"),
          .step = "CreateJob",
          .says_when_to_retry = says_when};
}

TEST(RunLog, CountsErrorsByStepAndReason) {
  RunLog log;
  log.Ended(0, 5, {});
  log.Ended(0, 6, Exhausted(true));
  log.Ended(0, 7, Exhausted(false));
  log.Ended(0, 8, Exhausted(false));
  const RunRecord record = log.Take();
  EXPECT_THAT(record.errors, ElementsAre(Pair("CreateJob: RESOURCE_EXHAUSTED OVERLOADED", 3)));
  EXPECT_EQ(record.succeeded(), 1);
  EXPECT_EQ(record.codes.at(absl::StatusCode::kResourceExhausted), 3);
  EXPECT_EQ(record.exhausted_with_retry_info, 1);
  EXPECT_EQ(record.exhausted_without_retry_info, 2);
}

TEST(RunLog, LatencyCountsFromTheIntendedStart) {
  RunLog log;
  log.Ended(100, 350, {});
  log.Ended(200, 300, Exhausted(true));
  const RunRecord record = log.Take();
  EXPECT_EQ(record.latency.count(), 2);
  EXPECT_EQ(record.latency.min_ns(), 100);
  EXPECT_EQ(record.latency.max_ns(), 250);
  EXPECT_EQ(record.end_ns, 350);
  EXPECT_EQ(record.samples[1].latency_ns, 100);
}

TEST(RunLog, SaysHowManySamplesItLeftOut) {
  RunLog log;
  for (size_t i = 0; i < RunLog::kMaxSamples + 3; ++i) log.Ended(0, 1, {});
  const RunRecord record = log.Take();
  EXPECT_EQ(record.samples.size(), RunLog::kMaxSamples);
  EXPECT_EQ(record.samples_left_out, 3);
  EXPECT_EQ(record.latency.count(), static_cast<int64_t>(RunLog::kMaxSamples) + 3);
}

TEST(RunLog, TakesFromManyThreads) {
  RunLog log;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int n = 0; n < 1000; ++n) {
        log.Arrived();
        log.Add(Tally::kEvents, 2);
        log.StepTook("GetJob", n);
        log.Ended(0, n, {});
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  const RunRecord record = log.Take();
  EXPECT_EQ(record.arrivals, 4000);
  EXPECT_EQ(record.succeeded(), 4000);
  EXPECT_EQ(record.tally(Tally::kEvents), 8000);
  EXPECT_EQ(record.steps.at("GetJob").count(), 4000);
}

}  // namespace
}  // namespace slicefarm::load::run_log_test
