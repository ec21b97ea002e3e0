#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/load/generator/client/fake_farm_test.h"
#include "tests/load/generator/client/run.h"

namespace slicefarm::load::load_test {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::Pair;

constexpr seconds kPatience{60};

/// Tests the generator with a fake coordinator in the same process.
class LoadTest : public testing::Test {
 protected:
  RunRecord RunIt(const ScenarioOptions& scenario_options, const RunOptions& options,
                  int connections = 2) {
    farm_ = Farm::Connect(fake_.address(), {}, connections, kPatience).value();
    const auto scenario = MakeScenario(scenario_options, *farm_);
    RunLog before;
    prepared_ = scenario->Prepare(
        {.deadline = std::chrono::system_clock::now() + kPatience, .log = &before});
    EXPECT_TRUE(prepared_.ok()) << prepared_;
    if (between_) between_();
    return load::Run(options, *scenario).record;
  }

  static RunOptions Rate(double rate_rps, double duration_s) {
    return {.rate_rps = rate_rps,
            .duration = std::chrono::duration<double>(duration_s),
            .deadline = kPatience,
            .seed = 5};
  }

  FakeFarm fake_;
  std::function<void()> between_;  ///< called between the preparation and the run
  std::unique_ptr<Farm> farm_;
  absl::Status prepared_;
};

std::vector<int64_t> Instants(const RunOptions& options) {
  PoissonArrivals arrivals(options.rate_rps, options.seed);
  const auto end_ns = std::chrono::nanoseconds(seconds(1)).count() * options.duration.count();
  std::vector<int64_t> instants;
  for (int64_t at = arrivals.NextNs(); static_cast<double>(at) < end_ns; at = arrivals.NextNs()) {
    instants.push_back(at);
  }
  return instants;
}

// The server answers 50 calls, stalls until 150 more calls have come, and continues. A generator
// that waited for answers would never have 150 calls in flight. A generator that measured from the
// actual start would show only a few slow calls.
TEST_F(LoadTest, AServerThatStallsShowsInAllArrivalsMeanwhile) {
  constexpr int kBefore = 50, kHeld = 150;
  const RunOptions options = Rate(500, 0.7);
  const auto instants = Instants(options);
  ASSERT_GT(instants.size(), 250u);
  ASSERT_LT(instants.size(), 400u);
  between_ = [&] { fake_.StandStill(kBefore, kHeld); };
  RunRecord record = RunIt({.kind = ScenarioKind::kGet}, options);

  ASSERT_EQ(record.succeeded(), static_cast<int64_t>(instants.size()));
  EXPECT_EQ(record.skipped, 0);
  std::sort(record.samples.begin(), record.samples.end(),
            [](const Sample& a, const Sample& b) { return a.intended_ns < b.intended_ns; });
  // The server continued after the 200th call, so not before the intended start of that call.
  const int64_t back_ns = instants[kBefore + kHeld - 1];
  int held = 0;
  for (size_t i = 0; i < instants.size(); ++i) {
    ASSERT_EQ(record.samples[i].intended_ns, instants[i]);
    held += instants[i] <= back_ns && record.samples[i].latency_ns >= back_ns - instants[i];
  }
  EXPECT_GE(held, kHeld);
  // 70 of the first 120 calls were held, which is more than a sixth of all.
  EXPECT_GE(record.latency.PercentileNs(83), back_ns - instants[119]);
}

TEST_F(LoadTest, WhatIsNotAnsweredEndsAtItsDeadlineAndWhatFindsNoSlotIsSkipped) {
  RunOptions options = Rate(500, 0.3);
  options.in_flight = 10;
  options.deadline = std::chrono::milliseconds(400);
  const auto arrivals = static_cast<int64_t>(Instants(options).size());
  between_ = [&] { fake_.StandStill(0, 1'000'000); };
  const RunRecord record = RunIt({.kind = ScenarioKind::kGet}, options);
  EXPECT_EQ(record.arrivals, arrivals);
  EXPECT_GT(record.skipped, 0);
  EXPECT_EQ(record.latency.count() + record.skipped, arrivals);
  EXPECT_EQ(record.succeeded(), 0);
  EXPECT_GE(record.latency.min_ns(), 390'000'000);  // deadlines are counted in milliseconds
  EXPECT_THAT(record.errors, ElementsAre(Pair("GetJob: DEADLINE_EXCEEDED DEADLINE_EXCEEDED",
                                              record.latency.count())));
}

TEST_F(LoadTest, PrintUploadsCreatesWatchesAndDownloads) {
  const RunRecord record =
      RunIt({.kind = ScenarioKind::kPrint, .parts = {.mix = Mix::kMedium}}, Rate(100, 0.2));
  const auto requests = static_cast<int64_t>(fake_.created.size());
  EXPECT_GT(requests, 0);
  EXPECT_EQ(record.succeeded(), requests);
  EXPECT_EQ(record.arrivals, requests);
  EXPECT_EQ(static_cast<int64_t>(fake_.meshes.size()), requests);  // each request has its own part
  EXPECT_EQ(record.tally(Tally::kBytesSent), requests * (84 + 50 * 5000));
  EXPECT_EQ(record.tally(Tally::kBytesReceived),
            requests * static_cast<int64_t>(fake_.gcode.size()));
  EXPECT_EQ(record.tally(Tally::kEvents), requests * FakeFarm::kEvents);
  for (const char* step : {"Upload", "CreateJob", "WatchOpen", "WatchJob", "Download"}) {
    ASSERT_TRUE(record.steps.contains(step)) << step;
    EXPECT_EQ(record.steps.at(step).count(), requests) << step;
  }
}

TEST_F(LoadTest, JobsOfBothProcessesByTurns) {
  RunIt({.kind = ScenarioKind::kSubmit, .processes = {Process::kFdm, Process::kLaser}},
        Rate(100, 0.3));
  ASSERT_GE(fake_.created.size(), 4u);
  const auto lasers = std::count_if(
      fake_.created.begin(), fake_.created.end(),
      [](const auto& request) { return request.spec().process() == v1::PROCESS_LASER; });
  EXPECT_EQ(lasers, static_cast<int64_t>(fake_.created.size() / 2));
}

TEST_F(LoadTest, TheSamePartIsUploadedOnce) {
  const RunRecord record =
      RunIt({.kind = ScenarioKind::kPrint, .parts = {.same = true}}, Rate(100, 0.2));
  EXPECT_EQ(fake_.meshes.size(), 1u);
  EXPECT_EQ(record.tally(Tally::kBytesSent), 0);
  EXPECT_EQ(record.succeeded(), record.arrivals);
}

TEST_F(LoadTest, EachRequestHasAnIdOfItsOwn) {
  RunIt({.kind = ScenarioKind::kSubmit}, Rate(200, 0.2));
  std::set<std::string> ids;
  std::set<double> scales;
  for (const auto& request : fake_.created) {
    ids.insert(request.request_id());
    scales.insert(request.spec().objects(0).placement().scale(0));
  }
  EXPECT_GT(ids.size(), 10u);
  EXPECT_EQ(ids.size(), fake_.created.size());
  EXPECT_EQ(scales.size(), fake_.created.size());  // other work each time
  EXPECT_EQ(fake_.meshes.size(), 1u);
}

TEST_F(LoadTest, ManyWatchersFollowEachJob) {
  const RunRecord record = RunIt({.kind = ScenarioKind::kWatch, .watchers = 20}, Rate(100, 0.1));
  EXPECT_GT(record.succeeded(), 0);
  EXPECT_EQ(record.succeeded(), record.arrivals);
  EXPECT_EQ(record.tally(Tally::kEvents), record.succeeded() * 20 * FakeFarm::kEvents);
  EXPECT_FALSE(record.steps.contains("Download"));
}

TEST_F(LoadTest, RefusalsAreErrorsByDefault) {
  between_ = [&] {
    fake_.refusals = 3;
    fake_.retry_after = "1";
  };
  const RunRecord record = RunIt({.kind = ScenarioKind::kSubmit}, Rate(200, 0.2));
  EXPECT_EQ(record.arrivals - record.succeeded(), 3);
  EXPECT_EQ(record.exhausted_with_retry_info, 3);
  EXPECT_EQ(record.exhausted_without_retry_info, 0);
  EXPECT_EQ(record.tally(Tally::kRetries), 0);
  EXPECT_THAT(record.errors, ElementsAre(Pair("CreateJob: RESOURCE_EXHAUSTED OVERLOADED", 3)));
}

TEST_F(LoadTest, WithRetryARefusedCallComesAgainWhenTheServerSays) {
  between_ = [&] {
    fake_.refusals = 3;
    fake_.retry_after = "1";
  };
  RunOptions options = Rate(200, 0.2);
  options.retry = true;
  const RunRecord record = RunIt({.kind = ScenarioKind::kSubmit}, options);
  EXPECT_EQ(record.succeeded(), record.arrivals);
  EXPECT_EQ(record.tally(Tally::kRetries), 3);
}

TEST_F(LoadTest, ARefusalThatNamesNoTimeIsNotRepeated) {
  between_ = [&] { fake_.refusals = 3; };
  RunOptions options = Rate(200, 0.2);
  options.retry = true;
  const RunRecord record = RunIt({.kind = ScenarioKind::kSubmit}, options);
  EXPECT_EQ(record.exhausted_without_retry_info, 3);
  EXPECT_EQ(record.tally(Tally::kRetries), 0);
}

TEST_F(LoadTest, AJobThatFailsIsAnErrorOfItsRequest) {
  fake_.end_state = v1::JOB_STATE_FAILED;
  const RunRecord record = RunIt({.kind = ScenarioKind::kPrint}, Rate(100, 0.1));
  EXPECT_EQ(record.succeeded(), 0);
  EXPECT_THAT(record.errors, ElementsAre(Pair("Job: INTERNAL RANGE_POISONED", record.arrivals)));
}

TEST_F(LoadTest, GCodeOfOtherBytesIsAnError) {
  fake_.gcode.back() = 'x';
  const RunRecord record = RunIt({.kind = ScenarioKind::kPrint}, Rate(100, 0.1));
  EXPECT_EQ(record.succeeded(), 0);
  EXPECT_THAT(record.errors,
              ElementsAre(Pair("Download: DATA_LOSS BLOB_DIGEST_MISMATCH", record.arrivals)));
}

TEST_F(LoadTest, AClosedLoopSendsOnlyAsManyAtOnce) {
  RunOptions options = Rate(0, 0.2);
  options.in_flight = 3;
  const RunRecord record = RunIt({.kind = ScenarioKind::kSubmit}, options);
  EXPECT_GT(record.succeeded(), 3);
  EXPECT_EQ(record.succeeded(), record.arrivals);
  EXPECT_EQ(record.skipped, 0);
}

TEST(Farm, ToldWhenNobodyAnswers) {
  const auto farm = Farm::Connect("127.0.0.1:1", {}, 1, std::chrono::milliseconds(50));
  EXPECT_EQ(farm.status().code(), absl::StatusCode::kUnavailable);
}

}  // namespace
}  // namespace slicefarm::load::load_test
