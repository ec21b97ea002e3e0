#include "services/coordinator/server/observe/metered_job_store.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/server/observe/metric_values_test.h"
#include "services/coordinator/store/jobs/sql_job_store.h"

namespace slicefarm::coordinator::metered_job_store_test {
namespace {

using enum JobState;

class MeteredJobStoreTest : public testing::Test {
 protected:
  std::optional<double> Value(const std::string& name,
                              const std::map<std::string, std::string>& labels = {}) {
    return MetricValue(registry_.Collect(), name, labels);
  }
  std::optional<double> Ended(const std::string& state, const std::string& reason = "") {
    return Value("slicefarm_jobs_total", {{"state", state}, {"reason", reason}});
  }
  std::optional<double> Commits(const std::string& operation) {
    return Value("slicefarm_store_commit_seconds", {{"operation", operation}});
  }

  void Make(const std::string& id, const std::string& request_id = "") {
    NewJob job;
    job.id = id;
    job.request_id = request_id;
    job.action_digest = "action";
    ASSERT_TRUE(store_.Create(job, ++now_us_).ok());
  }

  Lease Claim(const std::string& owner = "me") {
    const auto job = store_.Claim(owner, now_us_, now_us_ + 10);
    EXPECT_TRUE(job.ok() && *job);
    return {(*job)->id, (*job)->owner_epoch};
  }

  /// Makes a new job that this coordinator runs. Returns its lease.
  Lease Run(const std::string& id) {
    Make(id);
    const Lease lease = Claim();
    EXPECT_TRUE(Update(lease, {.state = kRunning}).ok());
    return lease;
  }

  absl::Status Update(const Lease& lease, const JobUpdate& update) {
    return store_.Update(lease, update, ++now_us_).status();
  }

  static JobResult Result(bool cached = false) {
    JobResult result;
    result.gcode_sha256 = "gcode";
    result.report_sha256 = "report";
    result.cached = cached;
    return result;
  }

  TempDirectory directory_;
  std::unique_ptr<JobStore> inner_ = *OpenSqliteJobStore(directory_.path() + "/jobs.db");
  prometheus::Registry registry_;
  MeteredJobStore store_{*inner_, registry_};
  int64_t now_us_ = 1'000'000;
};

TEST_F(MeteredJobStoreTest, CountersAreThereBeforeAnythingHappens) {
  EXPECT_EQ(Ended("SUCCEEDED"), 0);
  EXPECT_EQ(Ended("FAILED", "MESH_FORMAT_UNKNOWN"), 0);
  EXPECT_EQ(Ended("FAILED", "INTERNAL"), 0);
  EXPECT_EQ(Value("slicefarm_jobs_submitted_total"), 0);
  EXPECT_EQ(Value("slicefarm_cache_hits_total"), 0);
  EXPECT_EQ(Value("slicefarm_fenced_writes_total"), 0);
  EXPECT_EQ(Value("slicefarm_lease_expired_total"), 0);
  EXPECT_EQ(Value("slicefarm_job_seconds", {{"phase", "queue"}}), 0);
}

TEST_F(MeteredJobStoreTest, CountsJobsThatWereMadeOnce) {
  Make("a", "request");
  Make("b", "request");  // the same request again
  Make("c");
  EXPECT_EQ(Value("slicefarm_jobs_submitted_total"), 2);
  EXPECT_EQ(Commits("create"), 3);
}

TEST_F(MeteredJobStoreTest, CountsHowJobsEnd) {
  ASSERT_TRUE(Update(Run("a"), {.state = kSucceeded, .result = Result()}).ok());
  ASSERT_TRUE(Update(Run("b"), {.state = kFailed,
                                .error = JobErrorOf(MakeError(absl::StatusCode::kInternal,
                                                              Reason::kRangePoisoned, "x"))})
                  .ok());
  EXPECT_EQ(Ended("SUCCEEDED"), 1);
  EXPECT_EQ(Ended("FAILED", "RANGE_POISONED"), 1);
  EXPECT_EQ(Ended("FAILED", "INTERNAL"), 0);
  for (const char* phase : {"queue", "run", "total"}) {
    EXPECT_EQ(Value("slicefarm_job_seconds", {{"phase", phase}}), 2) << phase;
  }
}

TEST_F(MeteredJobStoreTest, ACancelIsCountedOnce) {
  Make("waits");
  ++now_us_;
  ASSERT_TRUE(store_.RequestCancel("waits", now_us_).ok());
  ++now_us_;
  ASSERT_TRUE(store_.RequestCancel("waits", now_us_).ok());
  EXPECT_EQ(Ended("CANCELLED"), 1);
  const Lease lease = Run("runs");
  ASSERT_TRUE(store_.RequestCancel("runs", ++now_us_).ok());
  EXPECT_EQ(Ended("CANCELLED"), 1) << "its owner has not ended it yet";
  ASSERT_TRUE(Update(lease, {.state = kQueued}).ok());
  EXPECT_EQ(Ended("CANCELLED"), 2) << "put back, but nobody wants it";
  EXPECT_EQ(Value("slicefarm_jobs_requeued_total", {{"cause", "other"}}), 0);
  EXPECT_EQ(Value("slicefarm_job_seconds", {{"phase", "run"}}), 1) << "one never ran";
}

TEST_F(MeteredJobStoreTest, TellsCachedResultsFromComputedOnes) {
  ASSERT_TRUE(Update(Run("a"), {.state = kSucceeded, .result = Result()}).ok());
  EXPECT_EQ(Value("slicefarm_cache_misses_total"), 1);
  EXPECT_EQ(Value("slicefarm_cache_hits_total"), 0);
  Make("b");
  ASSERT_TRUE(Update(Claim(), {.state = kSucceeded, .result = Result(true)}).ok());
  EXPECT_EQ(Value("slicefarm_cache_misses_total"), 1);
  EXPECT_EQ(Value("slicefarm_cache_hits_total"), 1);
}

TEST_F(MeteredJobStoreTest, ProgressIsNoMiss) {
  const Lease lease = Run("a");
  ASSERT_TRUE(Update(lease, {.state = kRunning, .layers_total = 9, .layers_done = 0}).ok());
  ASSERT_TRUE(Update(lease, {.state = kRunning, .layers_total = 9, .layers_done = 9}).ok());
  EXPECT_EQ(Value("slicefarm_cache_misses_total"), 1);
}

TEST_F(MeteredJobStoreTest, CountsJobsThatGoBackByTheirCause) {
  const auto count = [&](const char* cause) {
    return Value("slicefarm_jobs_requeued_total", {{"cause", cause}});
  };
  ASSERT_TRUE(
      Update(Run("a"), {.state = kQueued, .claimable_from_us = 1LL << 60, .retry = true}).ok());
  ASSERT_TRUE(
      Update(Run("b"), {.state = kQueued, .claimable_from_us = 1LL << 60, .store_failed = true})
          .ok());
  ASSERT_TRUE(Update(Run("c"), {.state = kQueued}).ok());
  EXPECT_EQ(count("services"), 1);
  EXPECT_EQ(count("store"), 1);
  EXPECT_EQ(count("other"), 1);
}

TEST_F(MeteredJobStoreTest, CountsTakeoversAndFencedWrites) {
  const Lease first = Run("a");
  now_us_ += 1000;
  const Lease second = Claim("another");
  EXPECT_EQ(Value("slicefarm_lease_expired_total"), 1);
  EXPECT_EQ(Value("slicefarm_fenced_writes_total"), 0);
  EXPECT_TRUE(absl::IsAborted(Update(first, {.state = kQueued})));
  EXPECT_TRUE(absl::IsAborted(store_.Adopt(first, {}, now_us_).status()));
  EXPECT_EQ(Value("slicefarm_fenced_writes_total"), 2);
  EXPECT_TRUE(Update(second, {.state = kQueued}).ok());
  Claim();
  EXPECT_EQ(Value("slicefarm_lease_expired_total"), 1) << "it was put back, and not left";
}

TEST_F(MeteredJobStoreTest, AClaimThatFindsNothingIsNoCommit) {
  ASSERT_TRUE(store_.Claim("me", now_us_, now_us_ + 10).ok());
  EXPECT_EQ(Commits("claim"), std::nullopt);
  Run("a");
  EXPECT_EQ(Commits("claim"), 1);
  EXPECT_EQ(Commits("update"), 1);
}

}  // namespace
}  // namespace slicefarm::coordinator::metered_job_store_test
