// Tests of schema migrations from an empty database and from every older version. Each of the disk
// calls fails, and the power fails after each. Environment variables:
//
//   SLICEFARM_FAULT_ERRORS   number of errors that are tried at each call site (5);
//   SLICEFARM_FAULT_SEEDS    number of random choices of the state after a power cut (1);
//   SLICEFARM_FAULT_EVERY    interval of the power cuts, in changes (3).

#include <gtest/gtest.h>

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/from_environment_test.h"
#include "services/coordinator/store/faults/database_invariants_test.h"
#include "services/coordinator/store/faults/fault_trials_test.h"
#include "services/coordinator/store/jobs/sql_job_store.h"
#include "services/coordinator/store/sql/sqlite_connection.h"
#include "services/coordinator/store/sql/sqlite_database.h"
#include "services/coordinator/store/sql/sqlite_schema.h"

namespace slicefarm::coordinator::sqlite_migration_faults_test {
namespace {

std::string PathIn(const std::string& directory) { return directory + "/jobs.db"; }

int64_t LatestVersion() {
  const auto db = *SqliteConnection::Open(":memory:");
  EXPECT_TRUE(MigrateSqlite(*db).ok());
  SqlQuery query(*db, "PRAGMA user_version");
  return query.Next() ? query.Int(0) : 0;
}

/// Creates a database of an older build with a job in it. For version 0, creates none.
void MakeVersion(const std::string& directory, int64_t version) {
  if (version == 0) return;
  DiskCalls quiet(directory);
  const auto db = *SqliteConnection::Open(PathIn(directory));
  ASSERT_TRUE(MigrateSqlite(*db, version).ok());
  const bool has_tenants = version >= 4;
  ASSERT_TRUE(
      db->Execute(absl::StrCat("INSERT INTO jobs (id, state, spec, labels, settings_digest,"
                               " action_digest, build_id, create_us) VALUES"
                               " ('a', 'QUEUED', x'00', '{\"order\": \"17\"}', 's', 'c', 'b', 5);"
                               "INSERT INTO requests (",
                               has_tenants ? "tenant, " : "",
                               "request_id, job_id, spec_digest, create_us) VALUES (",
                               has_tenants ? "'', " : "", "'r', 'a', 'd', 5);",
                               has_tenants ? "INSERT INTO labels VALUES (1, 'order', '17');" : ""))
          .ok());
}

class MigrationLife : public StoreLife {
 public:
  MigrationLife(std::string directory, int64_t from)
      : directory_(std::move(directory)), from_(from) {}

  absl::Status Open() override {
    auto database = SqliteDatabase::Open(PathIn(directory_));
    if (database.ok()) database_ = *std::move(database);
    return database.status();
  }
  void Close() override { database_.reset(); }
  std::vector<LifeStep> Steps() override { return {}; }

  std::vector<std::string> Check(const std::string& directory, size_t) const override {
    auto store = OpenSqliteJobStore(PathIn(directory));
    if (!store.ok()) return {store.status().ToString()};
    std::vector<std::string> wrong;
    if (from_ > 0 && (*store)->List({.labels = {{"order", "17"}}})->size() != 1)
      wrong.push_back("the old job is not found by its label");
    NewJob again;
    again.id = "b";
    again.request_id = "r";
    again.spec_digest = "d";
    const auto created = (*store)->Create(again, 6);
    if (!created.ok()) {
      wrong.push_back(created.status().ToString());
    } else if (from_ > 0 && created->job.id != "a") {
      wrong.push_back("the old request_id is forgotten");
    }
    store->reset();
    for (std::string& what : DatabaseContradictions(PathIn(directory)))
      wrong.push_back(std::move(what));
    return wrong;
  }

 private:
  const std::string directory_;
  const int64_t from_;
  std::unique_ptr<SqliteDatabase> database_;
};

class SqliteMigrationFaults : public testing::TestWithParam<int64_t> {
 protected:
  SqliteMigrationFaults() {
    const int64_t version = GetParam();
    options_.life = [version](DiskCalls&, const std::string& directory) {
      return std::make_unique<MigrationLife>(directory, version);
    };
    options_.prepare = [version](const std::string& directory) { MakeVersion(directory, version); };
  }

  TrialOptions options_;
};

INSTANTIATE_TEST_SUITE_P(From, SqliteMigrationFaults, testing::Range<int64_t>(0, LatestVersion()),
                         [](const auto& info) { return absl::StrCat("Version", info.param); });

TEST_P(SqliteMigrationFaults, ErrorsAreToldAndSeenTo) {
  options_.errors_a_site = FromEnvironment("SLICEFARM_FAULT_ERRORS", 5);
  ExpectErrorsAreSeenTo(options_);
}

TEST_P(SqliteMigrationFaults, APowerCutLeavesAnOldOrANewSchema) {
  options_.cut_every = FromEnvironment("SLICEFARM_FAULT_EVERY", 3);
  ExpectPowerCutsAreSurvived(options_, FromEnvironment("SLICEFARM_FAULT_SEEDS", 1));
}

}  // namespace
}  // namespace slicefarm::coordinator::sqlite_migration_faults_test
