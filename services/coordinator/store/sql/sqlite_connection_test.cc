#include "services/coordinator/store/sql/sqlite_connection.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"

namespace slicefarm::coordinator::sqlite_connection_test {
namespace {

class SqliteConnectionTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(db_->Execute("CREATE TABLE t (a INTEGER, b TEXT)").ok()); }

  int64_t Count() {
    SqlQuery query(*db_, "SELECT count(*) FROM t");
    return query.Next() ? query.Int(0) : -1;
  }

  TempDirectory directory_;
  std::unique_ptr<SqliteConnection> db_ = *SqliteConnection::Open(directory_.path() + "/x.db");
};

TEST_F(SqliteConnectionTest, BindsAndReads) {
  SqlQuery insert(*db_, "INSERT INTO t VALUES (?, ?)");
  ASSERT_TRUE(insert.Bind(int64_t{1} << 60, "it's").Run().ok());
  SqlQuery query(*db_, "SELECT a, b, NULL FROM t");
  ASSERT_TRUE(query.Next());
  EXPECT_EQ(query.Int(0), int64_t{1} << 60);
  EXPECT_EQ(query.Text(1), "it's");
  EXPECT_FALSE(query.Next());
  EXPECT_TRUE(query.status().ok());
}

TEST_F(SqliteConnectionTest, StatementsCanRunAgain) {
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(SqlQuery(*db_, "INSERT INTO t VALUES (?, '')").Bind(i).Run().ok());
  }
  EXPECT_EQ(Count(), 3);
}

TEST_F(SqliteConnectionTest, ErrorsStick) {
  SqlQuery query(*db_, "SELECT nonsense FROM nowhere");
  query.Bind(1);
  EXPECT_FALSE(query.Next());
  EXPECT_EQ(DetailOf(query.status()).reason, Reason::kStoreFailed);
}

TEST_F(SqliteConnectionTest, TransactionsRollBack) {
  {
    SqlTransaction transaction(*db_);
    ASSERT_TRUE(db_->Execute("INSERT INTO t VALUES (1, '')").ok());
  }
  EXPECT_EQ(Count(), 0);
  SqlTransaction transaction(*db_);
  ASSERT_TRUE(db_->Execute("INSERT INTO t VALUES (1, '')").ok());
  ASSERT_TRUE(transaction.Commit().ok());
  EXPECT_EQ(Count(), 1);
}

TEST_F(SqliteConnectionTest, IsDurable) {
  const auto pragma = [&](const char* sql) {
    SqlQuery query(*db_, sql);
    return query.Next() ? query.Text(0) : "";
  };
  EXPECT_EQ(pragma("PRAGMA journal_mode"), "wal");
  EXPECT_EQ(pragma("PRAGMA synchronous"), "2") << "FULL";
}

TEST_F(SqliteConnectionTest, AFullDatabaseIsToldAsSuch) {
  ASSERT_TRUE(db_->Execute("PRAGMA max_page_count = 4").ok());
  SqlQuery insert(*db_, "INSERT INTO t VALUES (1, ?)");
  EXPECT_EQ(DetailOf(insert.Bind(std::string(1 << 20, 'x')).Run()).reason, Reason::kDiskFull);
}

TEST(SqliteConnection, APlaceThatCannotBeIsAnError) {
  EXPECT_EQ(DetailOf(SqliteConnection::Open("/nowhere/x.db").status()).reason,
            Reason::kStoreFailed);
}

}  // namespace
}  // namespace slicefarm::coordinator::sqlite_connection_test
