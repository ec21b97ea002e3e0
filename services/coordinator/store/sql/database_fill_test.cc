#include "services/coordinator/store/sql/database_fill.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "services/coordinator/store/blobs/postgres_blob_store.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"

namespace slicefarm::coordinator::database_fill_test {
namespace {

// Otherwise, a database that was full once would never accept data again.
TEST(DatabaseFill, BlobsThatAreDeletedMakeRoom) {
  const std::shared_ptr<SqlDatabase> database =
      *PostgresDatabase::Open(SharedPostgres().NewDatabase());
  const auto empty = FillOf(*database);
  ASSERT_TRUE(empty.ok()) << empty.status();
  EXPECT_GT(empty->bytes, 0);
  EXPECT_GE(empty->connections, 1);
  EXPECT_GT(empty->max_connections, empty->connections);
  PostgresBlobStore blobs(database);
  constexpr int64_t kBytes = 5'000'000;
  const std::string digest = *blobs.Put(std::string(kBytes, 'x'));
  EXPECT_GE(FillOf(*database)->bytes, empty->bytes + kBytes);
  ASSERT_TRUE(*blobs.Delete(digest, 0));
  EXPECT_LT(FillOf(*database)->bytes, empty->bytes + kBytes);
}

}  // namespace
}  // namespace slicefarm::coordinator::database_fill_test
