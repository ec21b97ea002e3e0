#include "services/coordinator/store/sql/postgres_schema.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/postgres_blob_store.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/postgres_migrations.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"

namespace slicefarm::coordinator::postgres_schema_test {
namespace {

// A database from before blobs had tenants, with a blob in it.
TEST(PostgresSchema, KeepsWhatOldDatabasesHold) {
  const std::string database = SharedPostgres().NewDatabase();
  const std::string bytes = "some bytes";
  constexpr int kVersion = 5;
  {
    auto db = *PostgresConnection::Open(database);
    for (int version = 0; version < kVersion; ++version) {
      ASSERT_TRUE(db->Execute(kPostgresMigrations[version]).ok());
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
  EXPECT_TRUE(*blobs.Delete(Sha256Hex(bytes), 0));  // its pieces go with it
}

}  // namespace
}  // namespace slicefarm::coordinator::postgres_schema_test
