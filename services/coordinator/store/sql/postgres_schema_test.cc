#include "services/coordinator/store/sql/postgres_schema.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/postgres_blob_store.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/postgres_migrations.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"

namespace slicefarm::coordinator::postgres_schema_test {
namespace {

// The database has a blob from before blobs had tenants.
TEST(PostgresSchema, KeepsWhatOldDatabasesHold) {
  const std::string database = SharedPostgres().NewDatabase();
  const std::string bytes = "some bytes";
  constexpr int kVersion = 5;
  {
    auto db = *PostgresConnection::Open(database);
    for (int version = 0; version < kVersion; ++version) {
      ASSERT_TRUE(db->Execute(std::string(kPostgresMigrations[version].sql)).ok());
    }
    ASSERT_TRUE(db->Execute("CREATE TABLE slicefarm_schema (version BIGINT NOT NULL);"
                            "INSERT INTO slicefarm_schema VALUES (5);")
                    .ok());
    SqlQuery blob(*db, "INSERT INTO blobs (digest, size, complete) VALUES (?, 10, 1)");
    ASSERT_TRUE(blob.Bind(Sha256Hex(bytes)).Run().ok());
    SqlQuery piece(*db, "INSERT INTO blob_pieces (digest, at, bytes) VALUES (?, 0, ?)");
    ASSERT_TRUE(piece.Bind(Sha256Hex(bytes), Blob{bytes}).Run().ok());
  }
  auto migrated = PostgresDatabase::Open(database);
  ASSERT_TRUE(migrated.ok()) << migrated.status();
  PostgresBlobStore blobs(*std::move(migrated));
  EXPECT_EQ(*blobs.Get(Sha256Hex(bytes)), bytes);
  EXPECT_TRUE(*blobs.Delete(Sha256Hex(bytes), 0));  // the deletion includes its pieces
}

/// Steps of this build, and further steps of a newer build.
class NewerBuild {
 public:
  void Add(std::string_view name, std::string_view sql) { steps_.push_back({name, sql}); }
  absl::Status Migrate(SqlConnection& db) {
    taken_.clear();
    return MigratePostgres(db, steps_,
                           [this](std::string_view name) { taken_.emplace_back(name); });
  }
  const std::vector<std::string>& taken() const { return taken_; }

 private:
  std::vector<PostgresMigration> steps_{PostgresMigrations().begin(), PostgresMigrations().end()};
  std::vector<std::string> taken_;
};

int64_t Number(SqlConnection& db, std::string_view sql) {
  SqlQuery query(db, sql);
  EXPECT_TRUE(query.Next()) << query.status();
  return query.Int(0);
}

class PostgresMigrationTest : public testing::Test {
 protected:
  std::unique_ptr<PostgresConnection> Connect() { return *PostgresConnection::Open(database_); }

  const std::string database_ = SharedPostgres().NewDatabase();
  std::unique_ptr<PostgresConnection> db_ = Connect();
  NewerBuild newer_;
};

TEST_F(PostgresMigrationTest, EachStepIsTakenOnce) {
  newer_.Add("9001_more", "CREATE TABLE more (a BIGINT)");
  ASSERT_TRUE(newer_.Migrate(*db_).ok());
  EXPECT_EQ(newer_.taken().size(), PostgresMigrations().size() + 1);
  ASSERT_TRUE(newer_.Migrate(*db_).ok());
  EXPECT_THAT(newer_.taken(), testing::IsEmpty());
}

// During an upgrade, a moved pod of the old build starts again. A return to the old build must also
// be possible.
TEST_F(PostgresMigrationTest, AnOldBuildStartsBesideWhatANewOneAdded) {
  newer_.Add("9001_more", "ALTER TABLE jobs ADD COLUMN more BIGINT NOT NULL DEFAULT 0");
  ASSERT_TRUE(newer_.Migrate(*db_).ok());
  EXPECT_EQ(Number(*db_, "SELECT version FROM slicefarm_schema"), 8)
      << "builds from before slicefarm_migrations refuse more";
  const auto old = PostgresDatabase::Open(database_);
  ASSERT_TRUE(old.ok()) << old.status();
  NewJob job;
  job.id = "a";
  EXPECT_TRUE(
      SqlJobStore(std::shared_ptr<SqlDatabase>(old->get(), [](auto*) {})).Create(job, 5).ok());
}

TEST_F(PostgresMigrationTest, AnIndexIsMadeBesideWhoWrites) {
  ASSERT_TRUE(MigratePostgres(*db_).ok());
  const auto writer = Connect();
  ASSERT_TRUE(writer->Execute("SET idle_in_transaction_session_timeout = 0").ok());
  newer_.Add("9001_by_size",
             "CREATE INDEX CONCURRENTLY IF NOT EXISTS blobs_by_size ON blobs (size)");
  std::thread migration;
  {
    SqlTransaction writing(*writer);
    const std::string insert = "INSERT INTO blobs (digest, size, complete) VALUES ('a', 1, 1)";
    ASSERT_TRUE(writer->Execute(insert).ok());
    migration = std::thread([&] { EXPECT_TRUE(newer_.Migrate(*db_).ok()); });
    const auto other = Connect();
    while (Number(*other, "SELECT count(*) FROM pg_class WHERE relname = 'blobs_by_size'") == 0)
      std::this_thread::yield();
    ASSERT_TRUE(
        other->Execute("INSERT INTO blobs (digest, size, complete) VALUES ('b', 1, 1)").ok())
        << "which the index does not hold up";
    ASSERT_TRUE(writing.Commit().ok());
  }
  migration.join();
  EXPECT_EQ(Number(*db_,
                   "SELECT indisvalid FROM pg_index"
                   " WHERE indexrelid = 'blobs_by_size'::regclass"),
            1);
}

TEST_F(PostgresMigrationTest, AHalfIndexOfAnEndedProcessIsMadeAnew) {
  ASSERT_TRUE(MigratePostgres(*db_).ok());
  const std::string twins =
      "INSERT INTO blobs (tenant, digest, size, complete) VALUES ('', 'a', 1, 1), ('', 'b', 1, 1)";
  ASSERT_TRUE(db_->Execute(twins).ok());
  // The statement leaves an invalid index, because the rows are not unique.
  EXPECT_FALSE(db_->Execute("CREATE UNIQUE INDEX CONCURRENTLY blobs_by_size ON blobs (size)").ok());
  newer_.Add("9001_by_size",
             "CREATE INDEX CONCURRENTLY IF NOT EXISTS blobs_by_size ON blobs (size)");
  ASSERT_TRUE(newer_.Migrate(*db_).ok());
  EXPECT_EQ(Number(*db_,
                   "SELECT indisvalid FROM pg_index"
                   " WHERE indexrelid = 'blobs_by_size'::regclass"),
            1);
}

// A long read must not block all later transactions behind a step that waits for its lock.
TEST_F(PostgresMigrationTest, AStepWaitsForNoLockForLong) {
  ASSERT_TRUE(MigratePostgres(*db_).ok());
  const auto reader = Connect();
  ASSERT_TRUE(reader->Execute("SET idle_in_transaction_session_timeout = 0").ok());
  newer_.Add("9001_more", "ALTER TABLE jobs ADD COLUMN more BIGINT NOT NULL DEFAULT 0");
  std::thread migration;
  {
    SqlTransaction reading(*reader);
    ASSERT_TRUE(reader->Execute("SELECT count(*) FROM jobs").ok());
    migration = std::thread([&] { EXPECT_TRUE(newer_.Migrate(*db_).ok()); });
    const auto other = Connect();
    const std::string waits =
        "SELECT count(*) FROM pg_stat_activity WHERE datname = current_database()"
        " AND wait_event_type = 'Lock' AND query LIKE 'ALTER%'";
    while (Number(*other, waits) == 0) std::this_thread::yield();
    EXPECT_TRUE(other->Execute("SELECT count(*) FROM jobs").ok()) << "within its 30 s";
    EXPECT_TRUE(reading.Commit().ok());
  }
  migration.join();
}

TEST_F(PostgresMigrationTest, SeveralAtATimeTakeEachStepOnce) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      NewerBuild newer;
      newer.Add("9001_more", "CREATE TABLE more (a BIGINT)");
      newer.Add("9002_by_more", "CREATE INDEX CONCURRENTLY IF NOT EXISTS by_more ON more (a)");
      const absl::Status migrated = newer.Migrate(*Connect());
      EXPECT_TRUE(migrated.ok()) << migrated;
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST_F(PostgresMigrationTest, AFailedStepLeavesTheOnesBeforeAndIsTakenLater) {
  newer_.Add("9001_more", "CREATE TABLE more (a BIGINT)");
  newer_.Add("9002_bad", "CREATE TABLE other (a BIGINT); SELECT no_such_thing()");
  EXPECT_FALSE(newer_.Migrate(*db_).ok());
  EXPECT_EQ(newer_.taken().back(), "9001_more");
  NewerBuild mended;
  mended.Add("9001_more", "CREATE TABLE more (a BIGINT)");
  mended.Add("9002_bad", "CREATE TABLE other (a BIGINT)");
  ASSERT_TRUE(mended.Migrate(*db_).ok());
  EXPECT_THAT(mended.taken(), testing::ElementsAre("9002_bad"));
}

}  // namespace
}  // namespace slicefarm::coordinator::postgres_schema_test
