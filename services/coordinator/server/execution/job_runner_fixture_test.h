#pragma once

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "common/stage/exposure_stage.h"
#include "processes/list/jobs.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/server/api/job_intake.h"
#include "services/coordinator/server/execution/failing_job_store_test.h"
#include "services/coordinator/server/execution/fake_stages_test.h"
#include "services/coordinator/server/execution/job_runner.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/store/jobs/sql_job_store.h"

namespace slicefarm::coordinator {

/// Tests runs of jobs with real stores and fake stages, without a server.
class JobRunnerTest : public testing::Test {
 protected:
  using Call = FailingJobStore::Call;
  static constexpr int64_t kSecondUs = 1'000'000;

  /// `exposure`: stage of laser jobs; null: the coordinator runs no laser jobs.
  explicit JobRunnerTest(const ExposureStage* exposure = nullptr) : exposure_(exposure) {
    dispatcher_.Join({.name = "fake", .tasks = ranges_, .slots = 2});
  }

  ~JobRunnerTest() override { ranges_->LetGo(); }

  /// Returns the test's clock, which only Pass advances.
  int64_t NowUs() const { return now_us_; }
  void Pass(int64_t us) { now_us_ += us; }

  std::function<int64_t()> Clock() {
    return [this] { return NowUs(); };
  }

  /// Returns the switch that makes the stages of a process unfit.
  std::atomic<bool>& Unfit(Process process) { return unfit_[static_cast<size_t>(process)]; }

  std::unique_ptr<JobRunner> Runner(const std::string& owner = "me", int jobs = 2) {
    JobRunnerOptions options;
    options.owner = owner;
    options.jobs = jobs;
    options.poll = options.renew = std::chrono::milliseconds(10);
    auto runner = std::make_unique<JobRunner>(
        RunEnvironment{failing_, *blobs_, resolved_, results_, pipeline_, *memory_, feed_, Clock(),
                       "build", ResultSharing::kOff, rpc::JsonLog("test"), [](const StageTimes&) {},
                       [this](Process process) {
                         ++asked_;
                         return !Unfit(process);
                       },
                       [this] { return ++asked_for_room_, room_.load(); }},
        options);
    EXPECT_TRUE(runner->Start().ok());
    return runner;
  }

  std::string Submit(const std::string& mesh, const std::string& build = "build",
                     int64_t deadline_us = kNoDeadlineUs, const std::string& tenant = "",
                     v1::Process process = v1::PROCESS_FDM) {
    v1::JobSpec spec;
    spec.set_generic(true);
    spec.set_process(process);
    v1::Object* object = spec.add_objects();
    object->set_mesh_sha256(*(*blobs_->Of(tenant))->Put(mesh));
    object->set_name("part");
    ResolvedJobs resolved(build);
    const auto created = JobIntake(*jobs_, *blobs_, DiskGuard(nullptr, 0), budgets_, full_queues_,
                                   resolved, build, ResultSharing::kOff, Clock())
                             .Create({.tenant = tenant,
                                      .request_id = {},
                                      .spec_digest = Sha256Hex(SpecBytes(spec)),
                                      .spec = SpecBytes(spec),
                                      .request = *FromProto(spec),
                                      .labels = {},
                                      .deadline_us = deadline_us});
    EXPECT_TRUE(created.ok()) << created.status();
    return created->job.id;
  }

  /// Submits a job and waits until it runs. It runs until LetGo.
  std::string SubmitHeld(JobRunner& runner, const std::string& mesh = "xx") {
    ranges_->Hold();
    std::string id = Submit(mesh);
    runner.Wake();
    ranges_->AwaitCall();
    return id;
  }

  JobRecord AwaitEnd(const std::string& id) {
    std::mutex mutex;
    std::condition_variable changed;
    bool news = true;
    const int64_t ticket = feed_.Listen(id, [&](auto) {
      std::lock_guard lock(mutex);
      news = true;
      changed.notify_all();
    });
    JobRecord job;
    do {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return news; });
      news = false;
      lock.unlock();
      job = *jobs_->Get(id);
    } while (!IsTerminal(job.state));
    feed_.Forget(ticket);
    return job;
  }

  /// Waits for `count` further calls.
  void AwaitCalls(Call call, int count) {
    const int until = failing_.Calls(call) + count;
    while (failing_.Calls(call) < until) std::this_thread::yield();
  }

  TempDirectory directory_;
  std::unique_ptr<JobStore> jobs_ = *OpenSqliteJobStore(directory_.path() + "/jobs.db");
  FailingJobStore failing_{*jobs_};
  std::unique_ptr<BlobStores> blobs_ = *OpenDirectoryBlobs(directory_.path());
  FakeSlicing slicing_;
  FakePlanning planning_;
  FakeMotion motion_;
  std::shared_ptr<FakeRanges> ranges_ = std::make_shared<FakeRanges>();
  Dispatcher dispatcher_;
  const ExposureStage* const exposure_;
  JobPipeline pipeline_{
      JobsOver(
          {.slicing = &slicing_, .planning = &planning_, .motion = &motion_, .exposure = exposure_},
          ""),
      dispatcher_};
  std::unique_ptr<MemoryBudget> memory_ = std::make_unique<MemoryBudget>(1 << 30);
  ResolvedJobs resolved_{"build"};
  JobResults results_{failing_, *blobs_, {}};
  JobFeed feed_;
  TenantBudgets budgets_{*jobs_, *blobs_, Clock()};
  FullQueues full_queues_{Clock()};
  std::array<std::atomic<bool>, kProcessCount> unfit_ = {};  ///< switches by process
  std::atomic<bool> room_ = true;
  std::atomic<int> asked_ = 0;  ///< number of stages_fit calls
  std::atomic<int> asked_for_room_ = 0;
  std::atomic<int64_t> now_us_ = 1'000 * kSecondUs;
};

}  // namespace slicefarm::coordinator
