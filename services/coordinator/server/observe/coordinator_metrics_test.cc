#include "services/coordinator/server/observe/coordinator_metrics.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"
#include "common/rpc/event_test.h"
#include "processes/fdm/task/fdm_shared.h"
#include "services/coordinator/server/execution/fake_stages_test.h"
#include "services/coordinator/server/observe/metric_values_test.h"
#include "services/coordinator/store/jobs/forwarding_job_store.h"
#include "services/coordinator/store/jobs/sql_job_store.h"

namespace slicefarm::coordinator::coordinator_metrics_test {
namespace {

/// Longer than a store on a busy machine takes.
constexpr std::chrono::minutes kPatience(1);

/// Store that blocks until the test releases it.
class StuckJobStore : public ForwardingJobStore {
 public:
  using ForwardingJobStore::ForwardingJobStore;

  absl::StatusOr<std::vector<OpenJobs>> CountOpen() override {
    asked_.Happen();
    go_on_.Await();
    return store().CountOpen();
  }
  void AwaitCall() { asked_.Await(); }
  void GoOn() { go_on_.Happen(); }

 private:
  Event asked_;
  Event go_on_;
};

int64_t NowUs() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

class CoordinatorMetricsTest : public testing::Test {
 protected:
  std::optional<double> Value(const std::string& name,
                              const std::map<std::string, std::string>& labels = {}) {
    return MetricValue(metrics_.Collect(), name, labels);
  }

  void Make(const std::string& id, Priority priority, double age_s) {
    NewJob job;
    job.id = id;
    job.priority = priority;
    ASSERT_TRUE(jobs_->Create(job, NowUs() - static_cast<int64_t>(age_s * 1e6)).ok());
  }

  TempDirectory directory_;
  std::unique_ptr<JobStore> jobs_ = *OpenSqliteJobStore(directory_.path() + "/jobs.db");
  std::shared_ptr<FakeRanges> ranges_ = std::make_shared<FakeRanges>();
  Dispatcher dispatcher_;
  Fleet fleet_{dispatcher_};
  CoordinatorMetrics metrics_{
      {*jobs_, dispatcher_, fleet_, directory_.path(), nullptr, 0, 0, kPatience}};
};

TEST_F(CoordinatorMetricsTest, ShowsTheQueue) {
  EXPECT_EQ(Value("slicefarm_queue_age_seconds", {{"priority", "bulk"}}), 0);
  Make("a", Priority::kBulk, 1000);
  Make("b", Priority::kBulk, 10);
  Make("c", Priority::kInteractive, 5);
  EXPECT_EQ(Value("slicefarm_store_up"), 1);
  EXPECT_EQ(Value("slicefarm_jobs", {{"state", "QUEUED"}}), 3);
  EXPECT_EQ(Value("slicefarm_jobs", {{"state", "FAILED"}}), 0);
  EXPECT_EQ(Value("slicefarm_queue_depth", {{"priority", "bulk"}}), 2);
  EXPECT_EQ(Value("slicefarm_queue_depth", {{"priority", "normal"}}), 0);
  EXPECT_EQ(Value("slicefarm_queue_depth", {{"priority", "interactive"}}), 1);
  EXPECT_GE(Value("slicefarm_queue_age_seconds", {{"priority", "bulk"}}), 1000);
  EXPECT_LT(Value("slicefarm_queue_age_seconds", {{"priority", "interactive"}}), 1000);
}

TEST_F(CoordinatorMetricsTest, ShowsWhichStagesAreAway) {
  CoordinatorMetrics::Sources sources{*jobs_, dispatcher_, fleet_, ""};
  sources.stages_up = [] {
    return std::map<std::string, bool>{{"motion", true}, {"planning", false}};
  };
  const CoordinatorMetrics metrics(std::move(sources));
  const auto families = metrics.Collect();
  EXPECT_EQ(MetricValue(families, "slicefarm_stage_up", {{"stage", "motion"}}), 1);
  EXPECT_EQ(MetricValue(families, "slicefarm_stage_up", {{"stage", "planning"}}), 0);
}

TEST_F(CoordinatorMetricsTest, ShowsWhoIsBusy) {
  EXPECT_EQ(Value("slicefarm_workers"), 0);
  fleet_.Join({.name = "w:1", .tasks = ranges_, .slots = 2});
  fleet_.Join({.name = "w:2", .tasks = ranges_, .slots = 3});
  EXPECT_EQ(Value("slicefarm_workers"), 2);
  EXPECT_EQ(Value("slicefarm_worker_slots", {{"state", "busy"}}), 0);
  EXPECT_EQ(Value("slicefarm_worker_slots", {{"state", "idle"}}), 5);
  ranges_->Hold();
  std::thread job([&] {
    const std::vector<Task> tasks = {FdmTask{}};
    const auto take = [](size_t, const TaskResult&) { return absl::OkStatus(); };
    EXPECT_TRUE(dispatcher_.Execute({}, tasks, take, {}).ok());
  });
  ranges_->AwaitCall();
  EXPECT_EQ(Value("slicefarm_worker_slots", {{"state", "busy"}}), 1);
  EXPECT_EQ(Value("slicefarm_worker_slots", {{"state", "idle"}}), 4);
  EXPECT_EQ(Value("slicefarm_ranges_waiting"), 0);
  ranges_->LetGo();
  job.join();
  EXPECT_EQ(Value("slicefarm_ranges_total", {{"outcome", "ok"}}), 1);
  EXPECT_EQ(Value("slicefarm_worker_slots", {{"state", "busy"}}), 0);
}

// Autoscalers use this metric. The number of jobs alone does not show whether more workers would
// have work.
TEST_F(CoordinatorMetricsTest, ShowsHowManyRangesWait) {
  fleet_.Join({.name = "w:1", .tasks = ranges_, .slots = 1});
  ranges_->Hold();
  std::thread job([&] {
    const std::vector<Task> tasks = {FdmTask{}, FdmTask{}, FdmTask{}};
    const auto take = [](size_t, const TaskResult&) { return absl::OkStatus(); };
    EXPECT_TRUE(dispatcher_.Execute({}, tasks, take, {}).ok());
  });
  ranges_->AwaitCall();
  EXPECT_EQ(Value("slicefarm_ranges_waiting"), 2);
  ranges_->LetGo();
  job.join();
  EXPECT_EQ(Value("slicefarm_ranges_waiting"), 0);
}

TEST_F(CoordinatorMetricsTest, ShowsHowFullASharedDatabaseIs) {
  const auto fill = [] { return absl::StatusOr<DatabaseFill>(DatabaseFill{700, 25, 100}); };
  const CoordinatorMetrics shared({*jobs_, dispatcher_, fleet_, "", fill, 1000, 0, kPatience});
  EXPECT_EQ(MetricValue(shared.Collect(), "slicefarm_database_bytes"), 700);
  EXPECT_EQ(MetricValue(shared.Collect(), "slicefarm_database_max_bytes"), 1000);
  EXPECT_EQ(MetricValue(shared.Collect(), "slicefarm_database_connections"), 25);
  EXPECT_EQ(MetricValue(shared.Collect(), "slicefarm_database_max_connections"), 100);
  EXPECT_EQ(Value("slicefarm_database_bytes"), std::nullopt);
}

// Otherwise Prometheus would get no values at all, and report the coordinator as down.
TEST_F(CoordinatorMetricsTest, AStoreThatStandsStillKeepsNoMetricWaiting) {
  StuckJobStore stuck(*jobs_);
  const CoordinatorMetrics metrics(
      {stuck, dispatcher_, fleet_, directory_.path(), nullptr, 0, 0, std::chrono::milliseconds(1)});
  for (int i = 0; i < 3; ++i) {
    const auto families = metrics.Collect();
    EXPECT_EQ(MetricValue(families, "slicefarm_store_up"), 0);
    EXPECT_EQ(MetricValue(families, "slicefarm_workers"), 0);
    EXPECT_EQ(MetricValue(families, "slicefarm_jobs", {{"state", "QUEUED"}}), std::nullopt);
  }
  stuck.AwaitCall();
  stuck.GoOn();
  while (MetricValue(metrics.Collect(), "slicefarm_store_up") != 1) std::this_thread::yield();
  EXPECT_EQ(MetricValue(metrics_.Collect(), "slicefarm_jobs", {{"state", "QUEUED"}}), 0);
}

TEST_F(CoordinatorMetricsTest, TellsOfJobsThatShouldHaveGone) {
  constexpr double kDayS = 24 * 3600;
  const CoordinatorMetrics kept(
      {*jobs_, dispatcher_, fleet_, "", nullptr, 0, /*keep_jobs_s=*/2 * kDayS, kPatience});
  const auto overdue = [&] { return MetricValue(kept.Collect(), "slicefarm_retention_overdue"); };
  const auto end = [&](const std::string& id, double age_s) {
    Make(id, Priority::kNormal, age_s);
    const auto then_us = NowUs() - static_cast<int64_t>(age_s * 1e6);
    ASSERT_EQ(jobs_->RequestCancel(id, then_us)->state, JobState::kCancelled);
  };
  end("recent", 2.5 * kDayS);
  EXPECT_EQ(overdue(), 0);
  end("old", 3.5 * kDayS);
  EXPECT_EQ(overdue(), 1);
  EXPECT_EQ(Value("slicefarm_retention_overdue"), std::nullopt) << "jobs are kept for ever";
}

TEST_F(CoordinatorMetricsTest, ShowsWherePresetsWere) {
  const CoordinatorMetrics with_presets(
      {*jobs_, dispatcher_, fleet_, "", nullptr, 0, 0, kPatience, [] {
         return CoordinatorMetrics::PresetUses{7, 2};
       }});
  const auto uses = [&](const std::string& from) {
    return MetricValue(with_presets.Collect(), "slicefarm_preset_sets_total", {{"from", from}});
  };
  EXPECT_EQ(uses("memory"), 7);
  EXPECT_EQ(uses("store"), 2);
  EXPECT_EQ(Value("slicefarm_preset_sets_total", {{"from", "store"}}), std::nullopt);
}

TEST_F(CoordinatorMetricsTest, ShowsTheDiskOfAStateDirectoryOnly) {
  EXPECT_GT(Value("slicefarm_disk_size_bytes"), 0);
  EXPECT_GT(Value("slicefarm_disk_free_bytes"), 0);
  const CoordinatorMetrics shared({*jobs_, dispatcher_, fleet_, ""});
  EXPECT_EQ(MetricValue(shared.Collect(), "slicefarm_disk_free_bytes"), std::nullopt);
}

}  // namespace
}  // namespace slicefarm::coordinator::coordinator_metrics_test
