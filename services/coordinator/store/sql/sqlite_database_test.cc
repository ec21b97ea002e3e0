#include "services/coordinator/store/sql/sqlite_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/jobs/job_claims.h"
#include "services/coordinator/store/jobs/job_queue.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/sql/sqlite_connection.h"
#include "services/coordinator/store/sql/sqlite_schema.h"

namespace slicefarm::coordinator::sqlite_database_test {
namespace {

TEST(SqliteDatabase, RefusesANewerSchema) {
  TempDirectory directory;
  const std::string path = directory.path() + "/jobs.db";
  ASSERT_TRUE((*SqliteConnection::Open(path))->Execute("PRAGMA user_version = 999").ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(SqliteDatabase::Open(path).status()));
}

TEST(SqliteDatabase, RefusesWhatIsNoDatabase) {
  TempDirectory directory;
  const std::string path = directory.path() + "/jobs.db";
  std::ofstream(path) << std::string(5000, 'x');
  EXPECT_FALSE(SqliteDatabase::Open(path).ok());
}

TEST(SqliteDatabase, RefusesDamagedPages) {
  TempDirectory directory;
  const std::string path = directory.path() + "/jobs.db";
  {
    const std::shared_ptr<SqlDatabase> database = *SqliteDatabase::Open(path);
    SqlJobStore store(database);
    for (int i = 0; i < 200; ++i) {
      NewJob job;
      job.id = absl::StrCat("job-", i);
      job.spec = std::string(500, 's');
      ASSERT_TRUE(store.Create(job, i + 1).ok());
    }
  }
  ASSERT_TRUE((*SqliteConnection::Open(path))->Execute("PRAGMA wal_checkpoint(TRUNCATE)").ok());
  {
    constexpr int kPage = 4096;
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(2 * kPage);
    file << std::string(6 * kPage, '\x5A');
  }
  const absl::Status refused = SqliteDatabase::Open(path).status();
  EXPECT_TRUE(absl::IsFailedPrecondition(refused)) << refused;
  EXPECT_TRUE(absl::StrContains(refused.message(), "is damaged")) << refused;
}

// Otherwise, a list of a million rows would block the read of a single row.
TEST(SqliteDatabase, ManyReadAtATimeAndSeeWhatWasCommitted) {
  TempDirectory directory;
  const auto database = *SqliteDatabase::Open(directory.path() + "/jobs.db");
  std::vector<SqlSession> lists;
  for (int i = 1; i < SqliteDatabase::kReaders; ++i) {
    lists.push_back(*database->Read());
    SqlQuery list(*lists.back(), "SELECT id FROM jobs");
    EXPECT_FALSE(list.Next());
  }
  NewJob job;
  job.id = "a";
  SqlJobStore store(std::shared_ptr<SqlDatabase>(database.get(), [](SqlDatabase*) {}));
  ASSERT_TRUE(store.Create(job, 5).ok());
  EXPECT_EQ(store.Get("a")->id, "a");
  for (const SqlSession& list : lists) {
    SqlQuery again(*list, "SELECT id FROM jobs");
    EXPECT_TRUE(again.Next()) << again.status();
  }
}

TEST(SqliteSchema, MigratesOnce) {
  TempDirectory directory;
  const auto db = *SqliteConnection::Open(directory.path() + "/jobs.db");
  EXPECT_TRUE(MigrateSqlite(*db).ok());
  EXPECT_TRUE(MigrateSqlite(*db).ok());
}

// A return to the previous build must be possible. That build does not support the additions, so it
// must find its own version.
TEST(SqliteSchema, WhatIsAddedChangesNoVersion) {
  TempDirectory directory;
  const auto db = *SqliteConnection::Open(directory.path() + "/jobs.db");
  ASSERT_TRUE(MigrateSqlite(*db).ok());
  {
    SqlQuery version(*db, "PRAGMA user_version");
    ASSERT_TRUE(version.Next());
    EXPECT_EQ(version.Int(0), 12);
  }
  ASSERT_TRUE(db->Execute("INSERT INTO migrations (name) VALUES ('of a later build');"
                          "CREATE TABLE of_a_later_build (x INTEGER)")
                  .ok());
  EXPECT_TRUE(MigrateSqlite(*db).ok());
  SqlQuery added(*db, "SELECT count(*) FROM s3_blobs");
  EXPECT_TRUE(added.Next()) << added.status();
}

// The database has the version of the last build, but none of the additions.
TEST(SqliteSchema, AddsToWhatHasTheVersionAlready) {
  TempDirectory directory;
  const auto db = *SqliteConnection::Open(directory.path() + "/jobs.db");
  ASSERT_TRUE(MigrateSqlite(*db).ok());
  ASSERT_TRUE(db->Execute("DROP TABLE migrations; DROP TABLE s3_blobs; DROP TABLE s3_loose;"
                          "DROP TABLE presets;"
                          "DROP INDEX events_by_time; ALTER TABLE jobs DROP COLUMN deadly_runs")
                  .ok());
  ASSERT_TRUE(MigrateSqlite(*db).ok());
  SqlQuery added(*db, "SELECT count(*) FROM s3_loose");
  EXPECT_TRUE(added.Next()) << added.status();
}

/// Frequent queries must not read all jobs, all jobs of a tenant, or all waiting jobs.
TEST(SqliteSchema, ClaimingUsesAnIndex) {
  TempDirectory directory;
  const auto db = *SqliteConnection::Open(directory.path() + "/jobs.db");
  ASSERT_TRUE(MigrateSqlite(*db).ok());
  for (const std::string& sql : {TenantsSql(db->dialect()), ClaimableSql(db->dialect())}) {
    SqlQuery plan(*db, absl::StrCat("EXPLAIN QUERY PLAN ", sql));
    int reads = 0;
    while (plan.Next()) {
      const std::string step = plan.Text(3);
      if (!absl::StartsWith(step, "SEARCH") && !absl::StartsWith(step, "SCAN")) continue;
      if (absl::StrContains(step, "SCAN o")) continue;  // the list of tenants itself is scanned
      ++reads;
      EXPECT_THAT(step, testing::AnyOf(testing::HasSubstr("INDEX jobs_open"),
                                       testing::HasSubstr("INDEX jobs_held"),
                                       testing::HasSubstr("PRIMARY KEY")));
    }
    EXPECT_GT(reads, 0) << plan.status();
  }
}

// The queue is read often, so it must not read ended jobs.
TEST(SqliteSchema, TheQueueIsReadThroughIndexes) {
  TempDirectory directory;
  const auto db = *SqliteConnection::Open(directory.path() + "/jobs.db");
  ASSERT_TRUE(MigrateSqlite(*db).ok());
  const SqlDialect& dialect = db->dialect();
  for (const auto& [sql, index] : {std::pair(WaitingSql(dialect), "INDEX jobs_open"),
                                   std::pair(HeldSql(dialect), "INDEX jobs_held"),
                                   std::pair(LatestRunsSql(dialect), "INDEX jobs_by_end")}) {
    SqlQuery plan(*db, absl::StrCat("EXPLAIN QUERY PLAN ", sql));
    ASSERT_TRUE(plan.Next()) << plan.status();
    EXPECT_THAT(plan.Text(3), testing::HasSubstr(index));
  }
}

// The database is from the first build and has a job.
TEST(SqliteSchema, KeepsWhatOldDatabasesHold) {
  TempDirectory directory;
  const std::string path = directory.path() + "/jobs.db";
  {
    const auto db = *SqliteConnection::Open(path);
    ASSERT_TRUE(MigrateSqlite(*db, 3).ok());
    ASSERT_TRUE(db->Execute("INSERT INTO jobs (id, state, spec, labels, settings_digest,"
                            " action_digest, build_id, create_us) VALUES"
                            " ('a', 'QUEUED', x'00', '{\"order\": \"17\"}', 's', 'c', 'b', 5);"
                            "INSERT INTO requests VALUES ('r', 'a', 'd', 5);")
                    .ok());
  }
  const auto store = *OpenSqliteJobStore(path);
  EXPECT_EQ(store->List({.labels = {{"order", "17"}}})->size(), 1u);
  EXPECT_EQ((*store->Claim("me", 10, 20))->id, "a");
  NewJob again;
  again.request_id = "r";
  again.spec_digest = "d";
  EXPECT_EQ(store->Create(again, 30)->job.id, "a");
}

// In PostgreSQL each statement sees all earlier commits, so a deletion may occur between two
// statements.
TEST(SqlJobStore, ARequestWhoseJobIsBeingDeletedIsToBeMadeAgain) {
  TempDirectory directory;
  const std::string path = directory.path() + "/jobs.db";
  const auto store = *OpenSqliteJobStore(path);
  NewJob job;
  job.id = job.action_digest = "a";
  job.request_id = "r";
  ASSERT_TRUE(store->Create(job, 5).ok());
  ASSERT_TRUE((*SqliteConnection::Open(path))->Execute("DELETE FROM jobs").ok());
  const absl::Status again = store->Create(job, 6).status();
  EXPECT_TRUE(absl::IsUnavailable(again)) << again;
}

TEST(SqlJobStore, ADamagedRowIsToldOfAndKeepsNoOtherJobWaiting) {
  TempDirectory directory;
  const std::string path = directory.path() + "/jobs.db";
  const auto store = *OpenSqliteJobStore(path);
  for (const std::string id : {"damaged", "whole"}) {
    NewJob job;
    job.id = job.action_digest = id;
    job.deadline_us = 50;
    ASSERT_TRUE(store->Create(job, 5).ok());
  }
  const auto db = *SqliteConnection::Open(path);
  ASSERT_TRUE(db->Execute("UPDATE jobs SET labels = '{\"a' WHERE id = 'damaged'").ok());

  EXPECT_TRUE(absl::IsDataLoss(store->Get("damaged").status()));
  EXPECT_EQ(*store->TenantOf("damaged"), "");
  EXPECT_TRUE(absl::IsNotFound(store->TenantOf("never made").status()));
  EXPECT_TRUE(absl::IsDataLoss(store->Claim("me", 10, 20).status()));
  EXPECT_EQ((*store->Claim("me", 10, 20))->id, "whole");
  EXPECT_EQ(*store->Claim("me", 10, 20), std::nullopt);

  const auto listed = store->List({});
  ASSERT_TRUE(listed.ok()) << listed.status();
  ASSERT_EQ(listed->size(), 2u);
  EXPECT_FALSE(listed->front().error);
  EXPECT_EQ(listed->back().id, "damaged");
  EXPECT_EQ(listed->back().error->code, absl::StatusCode::kDataLoss);

  const auto overdue = store->EndOverdue({}, 60, 9);
  ASSERT_TRUE(overdue.ok()) << overdue.status();
  ASSERT_EQ(overdue->size(), 1u);
  EXPECT_EQ(overdue->front().id, "whole");

  EXPECT_TRUE(absl::IsDataLoss(store->Claim("me", 60, 70).status()));
}

}  // namespace
}  // namespace slicefarm::coordinator::sqlite_database_test
