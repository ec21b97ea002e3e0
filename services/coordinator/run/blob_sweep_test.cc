#include "services/coordinator/run/blob_sweep.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>

#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/blobs/swept_blob_store.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator::blob_sweep_test {
namespace {

class BlobSweepTest : public testing::Test {
 protected:
  std::string MakeJob(const std::string& id, const std::string& mesh,
                      const std::string& tenant = "") {
    NewJob job;
    job.tenant = tenant;
    job.id = id;
    job.action_digest = id;
    job.inputs = {mesh};
    EXPECT_TRUE(jobs_->Create(job, ++now_us_).ok());
    return id;
  }

  /// Claims the next job and ends it as SUCCEEDED.
  void Succeed(const std::string& gcode, const std::string& report) {
    ++now_us_;
    const auto job = *jobs_->Claim("me", now_us_, now_us_ + 1000);
    const Lease lease = {job->id, job->owner_epoch};
    JobUpdate update;
    ASSERT_TRUE(jobs_->Update(lease, update, now_us_).ok());
    update.state = JobState::kSucceeded;
    update.result.emplace().gcode_sha256 = gcode;
    update.result->report_sha256 = report;
    ASSERT_TRUE(jobs_->Update(lease, update, now_us_).ok());
  }

  Swept Sweep(const SweepOptions& options) {
    const auto swept = coordinator::Sweep(*jobs_, *stores_, options, now_us_);
    EXPECT_TRUE(swept.ok()) << swept.status();
    return *swept;
  }

  bool Has(const std::string& digest) { return blobs_->Open(digest).ok(); }

  TempDirectory directory_;
  std::unique_ptr<JobStore> jobs_ = *OpenSqliteJobStore(directory_.path() + "/jobs.db");
  std::unique_ptr<BlobStores> stores_ = *OpenDirectoryBlobs(directory_.path());
  std::shared_ptr<BlobStore> blobs_ = *stores_->Of("");
  int64_t now_us_ = 0;
};

TEST_F(BlobSweepTest, AStoreIsInUseAfterADayWithoutALongBreak) {
  constexpr int64_t kHourUs = int64_t{3600} * 1'000'000;
  struct Step {
    int64_t hour;
    bool in_use;
  };
  // A restart within a day changes nothing. After a break of two days, the database may be an old
  // backup.
  const Step steps[] = {{0, false}, {1, false},  {23, false},  {24, true},
                        {47, true}, {96, false}, {119, false}, {120, true}};
  for (const Step& step : steps) {
    const auto in_use = HasBeenInUse(*jobs_, {}, step.hour * kHourUs);
    ASSERT_TRUE(in_use.ok()) << in_use.status();
    EXPECT_EQ(*in_use, step.in_use) << step.hour;
  }
  EXPECT_TRUE(*HasBeenInUse(*jobs_, {.min_use_s = 0}, 1000 * kHourUs));
}

TEST_F(BlobSweepTest, KeepsWhatJobsReferTo) {
  const std::string mesh = *blobs_->Put("mesh"), other = *blobs_->Put("other mesh");
  const std::string gcode = *blobs_->Put("gcode"), report = *blobs_->Put("report");
  const std::string nobodys = *blobs_->Put("nobody's");
  MakeJob("done", mesh);
  Succeed(gcode, report);
  MakeJob("waiting", other);
  const Swept swept = Sweep({.keep_jobs_s = 0, .keep_blobs_s = 0});
  EXPECT_EQ(swept.blobs, 1);
  EXPECT_EQ(swept.bytes, 8);
  EXPECT_FALSE(Has(nobodys));
  for (const std::string& digest : {mesh, other, gcode, report}) EXPECT_TRUE(Has(digest));
}

TEST_F(BlobSweepTest, KeepsWhatWasJustUsed) {
  const std::string blob = *blobs_->Put("about to be referred to");
  EXPECT_EQ(Sweep({.keep_jobs_s = 0, .keep_blobs_s = 3600}).blobs, 0);
  EXPECT_TRUE(Has(blob));
}

TEST_F(BlobSweepTest, ADeletedJobsBlobsGo) {
  const std::string mesh = *blobs_->Put("mesh"), gcode = *blobs_->Put("gcode");
  const std::string id = MakeJob("a", mesh);
  Succeed(gcode, "");
  ASSERT_TRUE(jobs_->Delete(id).ok());
  EXPECT_EQ(Sweep({.keep_jobs_s = 0, .keep_blobs_s = 0}).blobs, 2);
}

TEST_F(BlobSweepTest, AJobThatCannotBeReadKeepsNoOtherNorAnyBlob) {
  const std::string nobodys = *blobs_->Put("nobody's");
  for (const char* id : {"damaged", "whole"}) {
    MakeJob(id, *blobs_->Put("mesh"));
    Succeed("", "");
  }
  const auto db = *SqliteConnection::Open(directory_.path() + "/jobs.db");
  ASSERT_TRUE(db->Execute("UPDATE jobs SET labels = '{' WHERE id = 'damaged'").ok());
  now_us_ += 10'000'000;
  const auto swept =
      coordinator::Sweep(*jobs_, *stores_, {.keep_jobs_s = 9, .keep_blobs_s = 0}, now_us_);
  EXPECT_TRUE(absl::IsDataLoss(swept.status())) << swept.status();
  EXPECT_TRUE(absl::IsNotFound(jobs_->Get("whole").status()));
  EXPECT_FALSE(Has(nobodys));
}

TEST_F(BlobSweepTest, JobsGoAfterTheirTime) {
  MakeJob("a", *blobs_->Put("mesh"));
  Succeed("", "");
  MakeJob("still waiting", *blobs_->Put("mesh"));
  now_us_ += 10'000'000;
  EXPECT_EQ(Sweep({.keep_jobs_s = 11, .keep_blobs_s = 3600}).jobs, 0);
  EXPECT_EQ(Sweep({.keep_jobs_s = 9, .keep_blobs_s = 3600}).jobs, 1);
  EXPECT_TRUE(absl::IsNotFound(jobs_->Get("a").status()));
  EXPECT_TRUE(jobs_->Get("still waiting").ok());
}

TEST_F(BlobSweepTest, WhatOneTenantNeedsKeepsNothingOfAnothers) {
  const auto of_a = *stores_->Of("a"), of_b = *stores_->Of("b");
  const std::string mesh = *of_a->Put("mesh");
  ASSERT_TRUE(of_b->Put("mesh").ok());
  ASSERT_TRUE(blobs_->Put("mesh").ok());
  MakeJob("of a", mesh, "a");
  EXPECT_EQ(Sweep({.keep_jobs_s = 0, .keep_blobs_s = 0}).blobs, 2);
  EXPECT_TRUE(of_a->Open(mesh).ok());
  EXPECT_FALSE(of_b->Open(mesh).ok());
  EXPECT_FALSE(Has(mesh));
}

TEST_F(BlobSweepTest, UploadsThatWereGivenUpGo) {
  const std::string digest(64, 'a');
  ASSERT_TRUE(blobs_->Append(digest, 0, "the first part").ok());
  EXPECT_EQ(Sweep({.keep_jobs_s = 0, .keep_blobs_s = 0}).blobs, 1);
  EXPECT_EQ(blobs_->Status(digest)->committed_size, 0);
}

TEST_F(BlobSweepTest, DamagedBlobsStayForSomeTime) {
  const std::string digest = *blobs_->Put("some bytes");
  const std::string path = directory_.path() + "/blobs/" + digest.substr(0, 2) + "/" + digest;
  std::ofstream(path) << "other bytes";
  ASSERT_TRUE(absl::IsDataLoss(blobs_->Get(digest).status()));
  EXPECT_EQ(Sweep({.keep_damaged_s = 3600}).bytes, 0);
  EXPECT_EQ(Sweep({.keep_damaged_s = 0}).bytes, 11);
  EXPECT_EQ(Sweep({.keep_damaged_s = 0}).bytes, 0);
}

/// Blob store with one blob that cannot be deleted.
class StuckStore : public SweptBlobStore {
 public:
  StuckStore(std::shared_ptr<BlobStore> store, std::string stuck)
      : store_(std::move(store)), stuck_(std::move(stuck)) {}

  absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) override {
    if (digest == stuck_) return absl::InternalError("it is stuck");
    return store_->Delete(digest, idle_s);
  }
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) override {
    return store_->ForEach(visit);
  }
  absl::StatusOr<BlobStatus> Status(const std::string& digest) override {
    return store_->Status(digest);
  }

 private:
  const std::shared_ptr<BlobStore> store_;
  const std::string stuck_;
};

class StuckStores : public BlobStores {
 public:
  explicit StuckStores(std::shared_ptr<BlobStore> store) : store_(std::move(store)) {}
  absl::StatusOr<std::shared_ptr<BlobStore>> Of(const std::string&) override { return store_; }
  absl::StatusOr<std::vector<std::string>> Tenants() override { return std::vector{std::string()}; }

 private:
  const std::shared_ptr<BlobStore> store_;
};

TEST_F(BlobSweepTest, WhatCannotBeDeletedKeepsNothingElse) {
  std::string stuck;
  for (int i = 0; i < 250; ++i) stuck = *blobs_->Put(std::to_string(i));
  StuckStores stores(std::make_shared<StuckStore>(blobs_, stuck));
  const auto swept =
      coordinator::Sweep(*jobs_, stores, {.keep_jobs_s = 0, .keep_blobs_s = 0}, now_us_);
  EXPECT_EQ(swept.status().message(), "it is stuck");
  int left = 0;
  ASSERT_TRUE(blobs_->ForEach([&](const BlobEntry&) { ++left; }).ok());
  EXPECT_EQ(left, 1);
}

}  // namespace
}  // namespace slicefarm::coordinator::blob_sweep_test
