#include "services/coordinator/store/sqlite_job_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/model/temp_directory_test.h"
#include "services/coordinator/store/sqlite_connection.h"
#include "services/coordinator/store/sqlite_job_rows.h"
#include "services/coordinator/store/sqlite_schema.h"

namespace slicefarm::coordinator {
namespace {

TEST(SqliteJobStore, RefusesANewerSchema) {
  TempDirectory directory;
  const std::string path = directory.path() + "/jobs.db";
  ASSERT_TRUE((*SqliteConnection::Open(path))->Execute("PRAGMA user_version = 999").ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(SqliteJobStore::Open(path).status()));
}

TEST(SqliteJobStore, RefusesWhatIsNoDatabase) {
  TempDirectory directory;
  const std::string path = directory.path() + "/jobs.db";
  std::ofstream(path) << std::string(5000, 'x');
  EXPECT_FALSE(SqliteJobStore::Open(path).ok());
}

TEST(SqliteSchema, MigratesOnce) {
  TempDirectory directory;
  const auto db = *SqliteConnection::Open(directory.path() + "/jobs.db");
  EXPECT_TRUE(MigrateSqlite(*db).ok());
  EXPECT_TRUE(MigrateSqlite(*db).ok());
}

/// What is asked all the time must not read whole tables.
TEST(SqliteSchema, ClaimingUsesAnIndex) {
  TempDirectory directory;
  const auto db = *SqliteConnection::Open(directory.path() + "/jobs.db");
  ASSERT_TRUE(MigrateSqlite(*db).ok());
  for (const char* sql : {kAnyClaimableSql, kClaimJobSql}) {
    SqliteQuery plan(*db, absl::StrCat("EXPLAIN QUERY PLAN ", sql));
    int reads = 0;
    while (plan.Next()) {
      if (!absl::StrContains(plan.Text(3), " jobs")) continue;
      ++reads;
      EXPECT_THAT(plan.Text(3), testing::HasSubstr("USING"));
    }
    EXPECT_GT(reads, 0);
  }
}

}  // namespace
}  // namespace slicefarm::coordinator
