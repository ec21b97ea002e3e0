#include "services/coordinator/server/main/migrate.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "services/coordinator/store/sql/postgres_connection.h"
#include "services/coordinator/store/sql/postgres_schema.h"

namespace slicefarm::coordinator {
namespace {

constexpr std::chrono::seconds kAskEvery{1};

/// Connects to the database. Waits up to `patience` for a server that starts at the same time.
absl::StatusOr<std::unique_ptr<PostgresConnection>> ConnectWithin(const std::string& conninfo,
                                                                  std::chrono::seconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (true) {
    // There is no time limit, because the creation of an index on a farm's tables may take long.
    auto connection = PostgresConnection::Open(conninfo, PostgresConnection::kNoLimit);
    if (connection.ok() || std::chrono::steady_clock::now() >= end) return connection;
    std::this_thread::sleep_for(kAskEvery);
  }
}

absl::Status MigrateAt(const std::string& conninfo, std::chrono::seconds patience) {
  const auto connection = ConnectWithin(conninfo, patience);
  if (!connection.ok()) return connection.status();
  return MigratePostgres(**connection, PostgresMigrations(), [](std::string_view name) {
    fmt::print("{}\n", name);
    std::fflush(stdout);
  });
}

}  // namespace

int Migrate(int argc, char** argv) {
  CLI::App app(
      "slicefarm-coordinator migrate: migrates a PostgreSQL database to the current schema, step "
      "by step");
  std::string conninfo;
  int patience_s = 60;
  app.add_option("--postgres", conninfo, "Connection string of the database")
      ->envname("SLICEFARM_POSTGRES")
      ->required();
  app.add_option("--wait", patience_s,
                 "Seconds for which a database server that does not answer is tried again")
      ->check(CLI::Range(0, 86'400))
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const absl::Status migrated = MigrateAt(conninfo, std::chrono::seconds(patience_s));
  if (migrated.ok()) return 0;
  fmt::print(stderr, "slicefarm-coordinator migrate: {}\n", std::string(migrated.message()));
  return 1;
}

}  // namespace slicefarm::coordinator
