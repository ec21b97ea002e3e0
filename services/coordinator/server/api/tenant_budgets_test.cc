#include "services/coordinator/server/api/tenant_budgets.h"

#include <gtest/gtest.h>

#include <memory>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"
#include "common/rpc/status_mapping.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::tenant_budgets_test {
namespace {

class TenantBudgetsTest : public testing::Test {
 protected:
  void Make(const std::string& id) {
    NewJob job;
    job.id = job.action_digest = id;
    job.tenant = "a";
    ASSERT_TRUE(jobs_.Create(job, 5).ok());
  }

  void Later() { now_us_ += 60'000'000; }

  TempDirectory directory_;
  MemoryJobs memory_;
  MemoryJobStore jobs_{memory_};
  std::unique_ptr<BlobStores> blobs_ = *OpenDirectoryBlobs(directory_.path());
  int64_t now_us_ = 0;
  TenantBudgets budgets_{jobs_, *blobs_, [this] { return now_us_; }};
};

TEST_F(TenantBudgetsTest, JobsCountWhenTheyHaveEndedToo) {
  Make("1");
  Make("2");
  ASSERT_TRUE(jobs_.RequestCancel("1", 6).ok());
  EXPECT_TRUE(budgets_.CheckJobs("a", 3, 1).ok());
  const ErrorDetail refusal = DetailOf(budgets_.CheckJobs("a", 3, 1));
  EXPECT_EQ(refusal.reason, Reason::kDiskLow) << "as one was taken since they were counted";
  EXPECT_EQ(refusal.metadata.at("budget"), "jobs");
  EXPECT_EQ(refusal.metadata.at("limit"), "3");
  EXPECT_EQ(refusal.metadata.at("got"), "4");
  EXPECT_TRUE(refusal.metadata.contains(rpc::kRetryAfterMs));
  EXPECT_TRUE(budgets_.CheckJobs("b", 3, 3).ok());
  ASSERT_TRUE(jobs_.Delete("1").ok());
  Later();
  EXPECT_TRUE(budgets_.CheckJobs("a", 3, 2).ok());
}

TEST_F(TenantBudgetsTest, BytesOfAllBlobsCount) {
  const auto blobs = *blobs_->Of("a");
  ASSERT_TRUE(blobs->Put("12345").ok());
  EXPECT_TRUE(budgets_.CheckBytes("a", 10, 5).ok());
  EXPECT_EQ(DetailOf(budgets_.CheckBytes("a", 10, 1)).metadata.at("budget"), "bytes");
  Later();
  EXPECT_TRUE(budgets_.CheckBytes("a", 10, 5).ok()) << "what was announced did not come";
  EXPECT_TRUE(budgets_.CheckBytes("b", 10, 10).ok());
}

TEST_F(TenantBudgetsTest, WithoutABudgetNothingIsCounted) {
  EXPECT_TRUE(budgets_.CheckBytes("no tenant's name!", INT64_MAX, 1).ok());
  EXPECT_FALSE(budgets_.CheckBytes("no tenant's name!", 1, 1).ok());
}

}  // namespace
}  // namespace slicefarm::coordinator::tenant_budgets_test
