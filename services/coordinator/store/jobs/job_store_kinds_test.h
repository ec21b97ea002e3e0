#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <barrier>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/from_environment_test.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"
#include "services/coordinator/store/store_location_test.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::job_store_contract_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;
using testing::UnorderedElementsAre;
using enum JobState;

/// Location of a job store in SQLite.
class SqliteLocation : public StoreLocation<JobStore> {
 public:
  std::unique_ptr<JobStore> Open() override {
    auto store = OpenSqliteJobStore(directory_.path() + "/jobs.db");
    EXPECT_TRUE(store.ok()) << store.status();
    return *std::move(store);
  }

 private:
  TempDirectory directory_;
};

/// Location of a job store in PostgreSQL.
class PostgresLocation : public StoreLocation<JobStore> {
 public:
  std::unique_ptr<JobStore> Open() override {
    auto database = PostgresDatabase::Open(database_);
    EXPECT_TRUE(database.ok()) << database.status();
    return std::make_unique<SqlJobStore>(*std::move(database));
  }

 private:
  const std::string database_ = SharedPostgres().NewDatabase();
};

/// Location of a job store in memory.
class MemoryLocation : public StoreLocation<JobStore> {
 public:
  std::unique_ptr<JobStore> Open() override { return std::make_unique<MemoryJobStore>(jobs_); }

 private:
  MemoryJobs jobs_;
};

inline const std::vector<StoreKind<JobStore>> kStores = {
    {"Memory", [] { return std::make_unique<MemoryLocation>(); }},
    {"Sqlite", [] { return std::make_unique<SqliteLocation>(); }},
    {"Postgres", [] { return std::make_unique<PostgresLocation>(); }},
};

/// Returns a job to be created.
inline NewJob JobOf(const std::string& id) {
  NewJob job;
  job.id = id;
  job.spec = std::string("spec\0of ", 8) + id;
  job.spec_digest = "spec-" + id;
  job.labels = {{"order", "17"}};
  job.settings_digest = "settings";
  job.action_digest = "action-" + id;
  job.inputs = {"mesh of " + id};
  job.traceparent = "00-trace-" + id;
  job.build_id = "build";
  return job;
}

/// Returns a result with these blobs.
inline JobResult ResultOf(const std::string& gcode, const std::string& report) {
  JobResult result;
  result.gcode_sha256 = gcode;
  result.gcode_size = 5;
  result.report_sha256 = report;
  result.print_time_s = 12.5;
  result.layers = 3;
  result.warnings = {"careful"};
  return result;
}

/// Runs `work(0)` to `work(threads - 1)` at the same time.
template <typename Work>
void Race(int threads, const Work& work) {
  std::vector<std::thread> racers;
  for (int i = 0; i < threads; ++i) racers.emplace_back([&, i] { work(i); });
  for (std::thread& racer : racers) racer.join();
}

/// Fixture of the contract tests.
class JobStoreTest : public testing::TestWithParam<StoreKind<JobStore>> {
 protected:
  void Make(const std::string& id) { ASSERT_TRUE(store_->Create(JobOf(id), ++now_).ok()); }

  Lease Claim(const std::string& owner = "me") {
    ++now_;
    const auto job = store_->Claim(owner, now_, now_ + 1000);
    EXPECT_TRUE(job.ok()) << job.status();
    if (!job.ok() || !*job) return {};
    return {(*job)->id, (*job)->owner_epoch};
  }

  absl::StatusOr<JobRecord> Update(const Lease& lease, JobState state) {
    JobUpdate update;
    update.state = state;
    return store_->Update(lease, update, ++now_);
  }

  absl::StatusOr<JobRecord> Succeed(const Lease& lease, const JobResult& result) {
    JobUpdate update;
    update.state = kSucceeded;
    update.result = result;
    return store_->Update(lease, update, ++now_);
  }

  /// Creates a job and ends it as SUCCEEDED.
  void MakeDone(const std::string& id, const JobResult& result) {
    Make(id);
    const Lease lease = Claim();
    ASSERT_EQ(lease.job_id, id);
    ASSERT_TRUE(Succeed(lease, result).ok());
  }

  std::unique_ptr<StoreLocation<JobStore>> location_ = GetParam().location();
  std::unique_ptr<JobStore> store_ = location_->Open();
  int64_t now_ = 1'000'000;
};

}  // namespace slicefarm::coordinator::job_store_contract_test
