#include "services/coordinator/server/api/job_intake.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/store/jobs/forwarding_job_store.h"
#include "services/coordinator/store/jobs/sql_job_store.h"

namespace slicefarm::coordinator::job_intake_test {
namespace {

class CountingJobStore : public ForwardingJobStore {
 public:
  using ForwardingJobStore::ForwardingJobStore;
  absl::StatusOr<Created> Create(const NewJob& job, int64_t now_us) override {
    ++creates_;
    return store().Create(job, now_us);
  }
  int creates_ = 0;
};

class JobIntakeTest : public testing::Test {
 protected:
  absl::StatusOr<Created> Create(const std::string& request_id) {
    v1::JobSpec spec;
    spec.set_generic(true);
    v1::Object* object = spec.add_objects();
    object->set_mesh_sha256(*(*blobs_->Of(""))->Put("mesh"));
    object->set_name("part");
    Submission submission;
    submission.max_open_jobs = 1;
    submission.request_id = request_id;
    submission.spec_digest = Sha256Hex(SpecBytes(spec));
    submission.spec = SpecBytes(spec);
    submission.request = *FromProto(spec);
    return intake_.Create(std::move(submission));
  }

  TempDirectory directory_;
  std::unique_ptr<JobStore> sqlite_ = *OpenSqliteJobStore(directory_.path() + "/jobs.db");
  CountingJobStore jobs_{*sqlite_};
  std::unique_ptr<BlobStores> blobs_ = *OpenDirectoryBlobs(directory_.path());
  int64_t now_us_ = 1'000'000;
  TenantBudgets budgets_{jobs_, *blobs_, [this] { return now_us_; }};
  FullQueues full_queues_{[this] { return now_us_; }};
  ResolvedJobs resolved_{"build"};
  const DiskGuard disk_{nullptr, 0};
  JobIntake intake_{jobs_,
                    *blobs_,
                    disk_,
                    budgets_,
                    full_queues_,
                    resolved_,
                    "build",
                    ResultSharing::kOff,
                    [this] { return now_us_; }};
};

TEST_F(JobIntakeTest, AFullQueueIsToldWithoutAWrite) {
  const auto first = Create("first");
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_EQ(DetailOf(Create("second").status()).reason, Reason::kQueueFull);
  ASSERT_EQ(jobs_.creates_, 2);
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(DetailOf(Create(i % 2 == 0 ? "" : "other").status()).reason, Reason::kQueueFull);
  EXPECT_EQ(jobs_.creates_, 2) << "which would hold up those of other tenants";
  const auto again = Create("first");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_FALSE(again->fresh);
  EXPECT_EQ(again->job.id, first->job.id);
  now_us_ += 2'000'000;
  EXPECT_EQ(DetailOf(Create("third").status()).reason, Reason::kQueueFull);
  EXPECT_EQ(jobs_.creates_, 3) << "looked at again in time";
}

TEST_F(JobIntakeTest, WhatIsTakenInIsResolvedOnceForItsRun) {
  const auto job = Create("");
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_TRUE(resolved_.Of(job->job.spec, ResultTenant(ResultSharing::kOff, "")).ok());
  EXPECT_EQ(resolved_.resolved(), 1);
}

}  // namespace
}  // namespace slicefarm::coordinator::job_intake_test
