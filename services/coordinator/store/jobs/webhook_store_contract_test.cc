// Contract tests of all WebhookStores. An entry in kStores adds an implementation.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/jobs/sql_webhook_store.h"
#include "services/coordinator/store/jobs/webhook_store.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"
#include "services/coordinator/store/sql/sqlite_database.h"
#include "services/coordinator/store/store_location_test.h"

namespace slicefarm::coordinator::webhook_store_contract_test {
namespace {

/// Job store and webhook store of one database, because webhooks are created with jobs.
struct JobsAndWebhooks {
  explicit JobsAndWebhooks(const std::shared_ptr<SqlDatabase>& database)
      : jobs(database), webhooks(database) {}

  SqlJobStore jobs;
  SqlWebhookStore webhooks;
};

class SqliteLocation : public StoreLocation<JobsAndWebhooks> {
 public:
  std::unique_ptr<JobsAndWebhooks> Open() override {
    return std::make_unique<JobsAndWebhooks>(*SqliteDatabase::Open(directory_.path() + "/db"));
  }

 private:
  TempDirectory directory_;
};

class PostgresLocation : public StoreLocation<JobsAndWebhooks> {
 public:
  std::unique_ptr<JobsAndWebhooks> Open() override {
    return std::make_unique<JobsAndWebhooks>(*PostgresDatabase::Open(database_));
  }

 private:
  const std::string database_ = SharedPostgres().NewDatabase();
};

const std::vector<StoreKind<JobsAndWebhooks>> kStores = {
    {"Sqlite", [] { return std::make_unique<SqliteLocation>(); }},
    {"Postgres", [] { return std::make_unique<PostgresLocation>(); }},
};

class WebhookStoreTest : public testing::TestWithParam<StoreKind<JobsAndWebhooks>> {
 protected:
  void Create(const std::string& id, const std::string& url = "https://a/",
              const std::string& tenant = "") {
    NewJob job;
    job.id = id;
    job.tenant = tenant;
    job.webhook_url = url;
    ASSERT_TRUE(store_->jobs.Create(job, 1).ok());
  }
  void End(const std::string& id, int64_t now_us) {
    ASSERT_TRUE(store_->jobs.RequestCancel(id, now_us).ok());
  }

  std::unique_ptr<StoreLocation<JobsAndWebhooks>> location_ = GetParam().location();
  std::unique_ptr<JobsAndWebhooks> store_ = location_->Open();
};

INSTANTIATE_TEST_SUITE_P(Stores, WebhookStoreTest, testing::ValuesIn(kStores),
                         [](const auto& info) { return info.param.name; });

TEST_P(WebhookStoreTest, IsDueWhenTheJobEnds) {
  Create("j");
  EXPECT_EQ(**store_->webhooks.Get("j"), (WebhookRecord{"https://a/"}));
  EXPECT_FALSE(store_->webhooks.Claim(1'000, 2'000)->has_value());
  End("j", 100);
  EXPECT_FALSE(store_->webhooks.Claim(99, 200)->has_value());
  const auto due = **store_->webhooks.Claim(100, 200);
  EXPECT_EQ(due.job_id, "j");
  EXPECT_EQ(due.url, "https://a/");
  EXPECT_EQ(due.attempt, 1);
}

TEST_P(WebhookStoreTest, AClaimThatIsNotRecordedRunsOut) {
  Create("j");
  End("j", 100);
  ASSERT_TRUE(store_->webhooks.Claim(100, 200)->has_value());
  EXPECT_FALSE(store_->webhooks.Claim(199, 300)->has_value());
  store_ = location_->Open();
  EXPECT_EQ((*store_->webhooks.Claim(200, 300))->attempt, 2);
}

TEST_P(WebhookStoreTest, TriesAreKept) {
  Create("j");
  End("j", 100);
  ASSERT_TRUE(store_->webhooks.Claim(100, 200)->has_value());
  const WebhookAttempt first = {1, 150, 503, "no"};
  ASSERT_TRUE(store_->webhooks.Record("j", first, WebhookState::kDue, 500).ok());
  EXPECT_FALSE(store_->webhooks.Claim(499, 600)->has_value());
  EXPECT_EQ((*store_->webhooks.Claim(500, 600))->attempt, 2);
  const WebhookAttempt second = {2, 550, 200, ""};
  ASSERT_TRUE(store_->webhooks.Record("j", second, WebhookState::kDelivered, 0).ok());
  EXPECT_FALSE(store_->webhooks.Claim(1'000'000, 1'000'001)->has_value());
  EXPECT_EQ(**store_->webhooks.Get("j"),
            (WebhookRecord{"https://a/", WebhookState::kDelivered, 0, {first, second}}));
}

TEST_P(WebhookStoreTest, AClaimThatRanOutDecidesNothing) {
  Create("j");
  End("j", 100);
  ASSERT_TRUE(store_->webhooks.Claim(100, 200)->has_value());
  ASSERT_TRUE(store_->webhooks.Claim(200, 300)->has_value());
  ASSERT_TRUE(store_->webhooks.Record("j", {2, 250, 200, ""}, WebhookState::kDelivered, 0).ok());
  ASSERT_TRUE(store_->webhooks.Record("j", {1, 290, 409, "twice"}, WebhookState::kDue, 400).ok());
  const WebhookRecord webhook = **store_->webhooks.Get("j");
  EXPECT_EQ(webhook.state, WebhookState::kDelivered);
  EXPECT_EQ(webhook.attempts.size(), 2U) << "but it is told";
}

TEST_P(WebhookStoreTest, BusyTenantsArePassedOver) {
  Create("a1", "https://a/", "a");
  Create("a2", "https://a/", "a");
  Create("b", "https://b/", "b");
  for (const char* id : {"a1", "a2", "b"}) End(id, 100);
  const auto first = **store_->webhooks.Claim(100, 200, {"b"});
  EXPECT_EQ(first.tenant, "a");
  EXPECT_EQ((*store_->webhooks.Claim(100, 200, {"a"}))->job_id, "b");
  EXPECT_FALSE(store_->webhooks.Claim(100, 200, {"a", "b"})->has_value());
  EXPECT_TRUE(store_->webhooks.Claim(100, 200)->has_value());
}

TEST_P(WebhookStoreTest, ItsJobIsNotOldBeforeItIsTold) {
  Create("j");
  End("j", 100);
  EXPECT_THAT(*store_->jobs.EndedBefore(1'000, 10), testing::IsEmpty());
  ASSERT_TRUE(store_->webhooks.Claim(100, 200)->has_value());
  ASSERT_TRUE(store_->webhooks.Record("j", {1, 150, 200, ""}, WebhookState::kDelivered, 0).ok());
  EXPECT_THAT(*store_->jobs.EndedBefore(1'000, 10), testing::ElementsAre("j"));
}

TEST_P(WebhookStoreTest, ItGoesWithItsJob) {
  Create("j");
  End("j", 100);
  ASSERT_TRUE(store_->webhooks.Claim(100, 200)->has_value());
  ASSERT_TRUE(store_->jobs.Delete("j").ok());
  EXPECT_TRUE(store_->webhooks.Record("j", {}, WebhookState::kDue, 300).ok());
  EXPECT_FALSE(store_->webhooks.Get("j")->has_value());
  EXPECT_FALSE(store_->webhooks.Claim(1'000, 2'000)->has_value());
}

TEST_P(WebhookStoreTest, JobsWithoutOneHaveNone) {
  Create("j", "");
  End("j", 100);
  EXPECT_FALSE(store_->webhooks.Get("j")->has_value());
  EXPECT_FALSE(store_->webhooks.Claim(1'000, 2'000)->has_value());
}

TEST_P(WebhookStoreTest, ManyClaimersGetEachOnce) {
  constexpr int kJobs = 40;
  for (int i = 0; i < kJobs; ++i) {
    Create(std::to_string(i));
    End(std::to_string(i), i);
  }
  std::atomic<int> claimed = 0;
  std::vector<std::thread> claimers;
  for (int t = 0; t < 4; ++t) {
    claimers.emplace_back([&] {
      while (claimed < kJobs) {
        const auto due = store_->webhooks.Claim(1'000, 2'000);
        ASSERT_TRUE(due.ok()) << due.status();
        if (*due) ++claimed;
      }
    });
  }
  for (std::thread& claimer : claimers) claimer.join();
  EXPECT_EQ(claimed, kJobs);
  EXPECT_FALSE(store_->webhooks.Claim(1'000, 2'000)->has_value());
}

}  // namespace
}  // namespace slicefarm::coordinator::webhook_store_contract_test
