#include "services/coordinator/store/sql/postgres_pulse.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "common/base/error.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"

namespace slicefarm::coordinator::postgres_pulse_test {
namespace {

using std::chrono::milliseconds;

constexpr PostgresPulse::Options kQuick = {milliseconds(20), milliseconds(1'000), milliseconds(0)};

/// Begins a pulse. Repeats the attempt while a busy machine is slower than kQuick.
absl::StatusOr<std::unique_ptr<PostgresPulse>> Begin(const std::string& database,
                                                     const std::string& name) {
  while (true) {
    auto pulse = PostgresPulse::Begin(database, name, kQuick);
    if (!absl::IsUnavailable(pulse.status())) return pulse;
  }
}

void Await(const PostgresPulse& pulse, bool silent) {
  while (pulse.silent() != silent) std::this_thread::yield();
}

TEST(PostgresPulse, NobodyWaitsForAServerThatStandsStill) {
  PostgresServer server;
  const std::string name = server.NewDatabase();
  const auto database = *PostgresDatabase::Open(name);
  const std::shared_ptr<const PostgresPulse> pulse = *Begin(name, "");
  database->Heed(pulse);
  const auto more = database->More();
  while (!database->Read().ok()) std::this_thread::yield();
  server.Pause();
  Await(*pulse, true);
  for (SqlDatabase* each : {database.get(), more.get()}) {
    const absl::Status away = each->Write().status();
    EXPECT_TRUE(absl::IsUnavailable(away)) << away;
    EXPECT_EQ(DetailOf(away).reason, Reason::kStoreFailed);
  }
  server.Resume();
  Await(*pulse, false);
  while (!more->Read().ok()) std::this_thread::yield();
}

TEST(PostgresPulse, OutlivesTheServer) {
  PostgresServer server;
  const std::string name = server.NewDatabase();
  const auto pulse = *Begin(name, "a");
  server.Kill();
  Await(*pulse, true);
  server.Start();
  Await(*pulse, false);
  // Waits until the first pulse has the name again.
  while (Begin(name, "a").ok()) std::this_thread::yield();
}

TEST(PostgresPulse, OneOfAName) {
  const std::string name = SharedPostgres().NewDatabase();
  auto first = *Begin(name, "a");
  const absl::Status second = Begin(name, "a").status();
  EXPECT_TRUE(absl::IsFailedPrecondition(second)) << second;
  EXPECT_THAT(std::string(second.message()), testing::HasSubstr("--name"));
  EXPECT_TRUE(Begin(name, "b").ok());
  EXPECT_TRUE(Begin(SharedPostgres().NewDatabase(), "a").ok());
  first.reset();
  while (!Begin(name, "a").ok()) std::this_thread::yield();
}

TEST(PostgresPulse, AnyNumberWithoutAName) {
  const std::string name = SharedPostgres().NewDatabase();
  const auto first = Begin(name, "");
  EXPECT_TRUE(first.ok());
  EXPECT_TRUE(Begin(name, "").ok());
}

}  // namespace
}  // namespace slicefarm::coordinator::postgres_pulse_test
