#include "services/coordinator/store/sql/postgres_connection.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"

namespace slicefarm::coordinator::postgres_connection_test {
namespace {

void ExpectAway(const absl::Status& status) {
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kStoreFailed);
  EXPECT_TRUE(DetailOf(status).metadata.contains(rpc::kRetryAfterMs));
}

class PostgresConnectionTest : public testing::Test {
 protected:
  const std::string database_ = SharedPostgres().NewDatabase();
  std::unique_ptr<PostgresConnection> db_ = *PostgresConnection::Open(database_);
};

TEST_F(PostgresConnectionTest, BindsAndReads) {
  ASSERT_TRUE(db_->Execute("CREATE TABLE t (a BIGINT, b TEXT, c BYTEA)").ok());
  SqlQuery insert(*db_, "INSERT INTO t VALUES (?, ?, ?)");
  const std::string bytes("a\0\xff", 3);
  ASSERT_TRUE(insert.Bind(-(int64_t{1} << 60), "it's", Blob{bytes}).Run().ok());
  SqlQuery query(*db_, "SELECT a, b, c, NULL, 7::INT4, true FROM t");
  ASSERT_TRUE(query.Next());
  EXPECT_EQ(query.Int(0), -(int64_t{1} << 60));
  EXPECT_EQ(query.Text(1), "it's");
  EXPECT_EQ(query.Text(2), bytes);
  EXPECT_EQ(query.Text(3), "");
  EXPECT_EQ(query.Int(4), 7);
  EXPECT_EQ(query.Int(5), 1);
  EXPECT_FALSE(query.Next());
  EXPECT_TRUE(query.status().ok());
}

TEST_F(PostgresConnectionTest, ErrorsStick) {
  SqlQuery query(*db_, "SELECT nonsense FROM nowhere");
  query.Bind(1);
  EXPECT_FALSE(query.Next());
  EXPECT_EQ(DetailOf(query.status()).reason, Reason::kStoreFailed);
  EXPECT_TRUE(db_->alive());
}

// Otherwise the text would be cut off at the NUL.
TEST_F(PostgresConnectionTest, ATextWithANulIsRefused) {
  SqlQuery query(*db_, "SELECT ?::TEXT");
  query.Bind(std::string("a\0b", 3));
  EXPECT_FALSE(query.Next());
  EXPECT_EQ(DetailOf(query.status()).reason, Reason::kRequestMalformed);
}

TEST_F(PostgresConnectionTest, TransactionsRollBack) {
  ASSERT_TRUE(db_->Execute("CREATE TABLE t (a BIGINT)").ok());
  {
    SqlTransaction transaction(*db_);
    ASSERT_TRUE(db_->Execute("INSERT INTO t VALUES (1)").ok());
  }
  SqlQuery query(*db_, "SELECT count(*) FROM t");
  ASSERT_TRUE(query.Next());
  EXPECT_EQ(query.Int(0), 0);
}

TEST(PostgresConnection, APlaceThatCannotBeSaysWhenToTryAgain) {
  ExpectAway(PostgresConnection::Open("host=/nowhere dbname=x").status());
}

TEST_F(PostgresConnectionTest, RefusesANewerSchema) {
  ASSERT_TRUE(PostgresDatabase::Open(database_).ok());
  ASSERT_TRUE(db_->Execute("UPDATE slicefarm_schema SET version = 999").ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(PostgresDatabase::Open(database_).status()));
}

constexpr PostgresConnection::Limit kShort = std::chrono::seconds(1);

TEST_F(PostgresConnectionTest, AStatementThatTakesTooLongEnds) {
  const auto db = *PostgresConnection::Open(database_, kShort);
  ExpectAway(SqlQuery(*db, "SELECT pg_sleep(600)").Run());
  EXPECT_TRUE(db->alive()) << "the server said so itself";
  EXPECT_TRUE(SqlQuery(*db, "SELECT 1").Run().ok());
}

// Otherwise, a coordinator that is stopped in the middle of a claim would block the claims of all
// others.
TEST_F(PostgresConnectionTest, ATransactionThatStandsStillGivesUpItsLocks) {
  ASSERT_TRUE(db_->Execute("CREATE TABLE t (a BIGINT); INSERT INTO t VALUES (1)").ok());
  const auto stopped = *PostgresConnection::Open(database_);
  SqlTransaction transaction(*stopped);
  ASSERT_TRUE(SqlQuery(*stopped, "UPDATE t SET a = 2").Run().ok());
  EXPECT_TRUE(SqlQuery(*db_, "UPDATE t SET a = 3").Run().ok());
  ExpectAway(SqlQuery(*stopped, "UPDATE t SET a = 4").Run());
  EXPECT_FALSE(stopped->alive());
}

TEST_F(PostgresConnectionTest, KeepsSoManyStatementsAndNoMore) {
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 300; ++i) {
      SqlQuery query(*db_, absl::StrCat("SELECT ?::BIGINT + ", i));
      ASSERT_TRUE(query.Bind(1000).Next()) << query.status();
      EXPECT_EQ(query.Int(0), 1000 + i);
    }
  }
  SqlQuery kept(*db_, "SELECT count(*) FROM pg_prepared_statements");
  ASSERT_TRUE(kept.Next());
  EXPECT_EQ(kept.Int(0), 128);
}

/// The kernel of the server still accepts bytes, but the server does not answer.
TEST_F(PostgresConnectionTest, AServerThatStandsStillIsAway) {
  PostgresServer server;
  const std::string database = server.NewDatabase();
  constexpr const char* kLength = "SELECT length(?::BYTEA)";
  const std::vector<std::string> sent = {"little", std::string(8 << 20, 'x')};
  std::vector<std::unique_ptr<PostgresConnection>> connections;
  for (size_t i = 0; i < sent.size(); ++i) {
    connections.push_back(*PostgresConnection::Open(database, kShort));
    ASSERT_TRUE(SqlQuery(*connections[i], kLength).Bind(Blob{"a"}).Run().ok());
  }
  server.Pause();
  for (size_t i = 0; i < sent.size(); ++i) {
    SCOPED_TRACE(sent[i].size());
    ExpectAway(SqlQuery(*connections[i], kLength).Bind(Blob{sent[i]}).Run());
    EXPECT_FALSE(connections[i]->alive()) << "an answer that comes late is to no question";
    ExpectAway(connections[i]->Execute("SELECT 1"));
  }
  server.Resume();
  EXPECT_TRUE(SqlQuery(**PostgresConnection::Open(database), "SELECT 1").Run().ok());
}

TEST_F(PostgresConnectionTest, ServesAgainAfterTheServerWasKilled) {
  PostgresServer server;
  const auto database = *PostgresDatabase::Open(server.NewDatabase());
  EXPECT_TRUE(SqlQuery(**database->Read(), "SELECT 1").Run().ok());
  server.Kill();
  ExpectAway(SqlQuery(**database->Read(), "SELECT 1").Run());
  ExpectAway(database->Read().status());
  server.Start();
  const auto session = *database->Read();
  EXPECT_TRUE(SqlQuery(*session, "SELECT 1").Run().ok());
}

}  // namespace
}  // namespace slicefarm::coordinator::postgres_connection_test
