#include "services/coordinator/server/main/stores.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "services/coordinator/store/s3/fake_s3_test.h"
#include "services/coordinator/store/sql/postgres_connection.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"

namespace slicefarm::coordinator::stores_test {
namespace {

constexpr int64_t kNow = 1'000'000;
constexpr int64_t kUntil = 9'000'000;

NewJob Job(const std::string& id) {
  NewJob job;
  job.id = id;
  job.spec = "spec";
  job.action_digest = id;
  return job;
}

/// Waits until `calls` calls wait for a lock of another connection.
void AwaitBlocked(SqlConnection& db, int64_t calls) {
  while (true) {
    SqlQuery query(db,
                   "SELECT count(*) FROM pg_stat_activity"
                   " WHERE datname = current_database() AND wait_event_type = 'Lock'");
    ASSERT_TRUE(query.Next()) << query.status();
    if (query.Int(0) >= calls) return;
    std::this_thread::yield();
  }
}

// Otherwise, a few slow calls of one tenant could end the runs of all tenants' jobs.
TEST(Stores, CallersWhoTakeAllConnectionsKeepNoLeaseWaiting) {
  const std::string database = SharedPostgres().NewDatabase();
  const auto stores = OpenStores({.state_dir = "", .postgres = database}, /*runs=*/3);
  ASSERT_TRUE(stores.ok()) << stores.status();
  ASSERT_TRUE(stores->jobs->Create(Job("run"), kNow).ok());
  const auto claimed = stores->runs->Claim("owner", kNow, kUntil);
  ASSERT_TRUE(claimed.ok() && *claimed) << claimed.status();
  ASSERT_TRUE(stores->jobs->Create(Job("wanted"), kNow).ok());

  const auto locker = PostgresConnection::Open(database);
  const auto watcher = PostgresConnection::Open(database);
  ASSERT_TRUE(locker.ok() && watcher.ok());
  // The lock must outlast the limit on idle transactions, even if the callers come late.
  ASSERT_TRUE((*locker)->Execute("SET idle_in_transaction_session_timeout = 0").ok());
  SqlTransaction lock(**locker);
  ASSERT_TRUE((*locker)->Execute("SELECT 1 FROM jobs WHERE id = 'wanted' FOR UPDATE").ok());
  std::vector<std::thread> callers;
  for (int i = 0; i < PostgresDatabase::kConnections; ++i) {
    callers.emplace_back([&] { EXPECT_TRUE(stores->jobs->RequestCancel("wanted", kNow).ok()); });
  }
  AwaitBlocked(**watcher, PostgresDatabase::kConnections);
  const Lease lease{(*claimed)->id, (*claimed)->owner_epoch};
  const auto held = stores->runs->Renew({lease}, kUntil + 1);
  EXPECT_TRUE(held.ok() && held->size() == 1) << held.status();
  EXPECT_TRUE(lock.Commit().ok());
  for (std::thread& caller : callers) caller.join();
}

TEST(Stores, ABucketThatRefusesUsIsToldAtTheStart) {
  const FakeS3 bucket;
  const TempDirectory directory;
  StoreOptions options{.state_dir = directory.path(), .postgres = ""};
  options.s3 = bucket.Client("another secret");
  const absl::Status refused = OpenStores(options, 1).status();
  EXPECT_TRUE(absl::IsFailedPrecondition(refused)) << refused;
  EXPECT_EQ(DetailOf(refused).reason, Reason::kStoreFailed);
  options.s3 = bucket.Client();
  const auto stores = OpenStores(options, 1);
  ASSERT_TRUE(stores.ok()) << stores.status();
  const auto digest = (*stores->blobs->Of("acme"))->Put("a result");
  ASSERT_TRUE(digest.ok()) << digest.status();
  EXPECT_EQ(*(*stores->blobs->Of("acme"))->Get(*digest), "a result");
  EXPECT_FALSE((*stores->blobs->Of(""))->Status(*digest)->complete);
  EXPECT_EQ(stores->blobs->Tenants()->size(), 2u);
}

// The sweep of a new database would delete all these blobs.
TEST(Stores, BlobsWithoutTheirDatabaseAreRefused) {
  for (const char* tenant : {"", "acme"}) {
    const TempDirectory directory;
    const StoreOptions options{.state_dir = directory.path(), .postgres = ""};
    std::string digest;
    {
      const auto stores = OpenStores(options, 1);
      ASSERT_TRUE(stores.ok()) << stores.status();
      digest = *(*stores->blobs->Of(tenant))->Put("a result");
    }
    const std::string database = directory.path() + "/jobs.db";
    for (const bool is_empty : {true, false}) {
      std::filesystem::rename(database, database + ".kept");
      if (is_empty) std::ofstream(database).flush();
      const absl::Status refused = OpenStores(options, 1).status();
      EXPECT_TRUE(absl::IsFailedPrecondition(refused)) << refused;
      EXPECT_NE(refused.message().find(is_empty ? "jobs.db is empty" : "jobs.db is missing"),
                std::string::npos)
          << refused;
      std::filesystem::rename(database + ".kept", database);
    }
    const auto stores = OpenStores(options, 1);
    ASSERT_TRUE(stores.ok()) << stores.status();
    EXPECT_EQ(*(*stores->blobs->Of(tenant))->Get(digest), "a result");
  }
}

// Otherwise, a computed result would be lost because no connection is free to store it.
TEST(Stores, TransfersThatTakeAllConnectionsKeepNoResultWaiting) {
  const std::string database = SharedPostgres().NewDatabase();
  const auto stores = OpenStores({.state_dir = "", .postgres = database}, /*runs=*/3);
  ASSERT_TRUE(stores.ok()) << stores.status();
  const std::string mesh(64, 'a');  // used as a digest
  ASSERT_TRUE((*stores->blobs->Of(""))->Append(mesh, 0, "v").ok());

  const auto locker = PostgresConnection::Open(database);
  const auto watcher = PostgresConnection::Open(database);
  ASSERT_TRUE(locker.ok() && watcher.ok());
  ASSERT_TRUE((*locker)->Execute("SET idle_in_transaction_session_timeout = 0").ok());
  SqlTransaction lock(**locker);
  ASSERT_TRUE((*locker)->Execute("SELECT 1 FROM blobs FOR UPDATE").ok());
  std::vector<std::thread> uploads;
  for (int i = 0; i < PostgresDatabase::kConnections; ++i) {
    uploads.emplace_back(
        [&] { EXPECT_TRUE((*stores->blobs->Of(""))->Append(mesh, 0, "vw").ok()); });
  }
  AwaitBlocked(**watcher, PostgresDatabase::kConnections);
  const auto kept = (*stores->run_blobs->Of(""))->Put("a result");
  EXPECT_TRUE(kept.ok()) << kept.status();
  EXPECT_TRUE(lock.Commit().ok());
  for (std::thread& upload : uploads) upload.join();
}

}  // namespace
}  // namespace slicefarm::coordinator::stores_test
