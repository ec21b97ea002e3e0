#include "services/coordinator/store/sql/postgres_database.h"

#include <chrono>
#include <utility>

#include "common/base/error.h"
#include "services/coordinator/store/sql/postgres_schema.h"

namespace slicefarm::coordinator {
namespace {

/// Longest wait for a connection. It is shorter than a lease, so that the renewal of a lease gets
/// the error in time.
constexpr std::chrono::seconds kPatience{5};

}  // namespace

absl::StatusOr<std::unique_ptr<PostgresDatabase>> PostgresDatabase::Open(
    const std::string& conninfo, int max_connections) {
  // There is no time limit, because the creation of an index on a farm's tables may take long.
  const auto patient = PostgresConnection::Open(conninfo, PostgresConnection::kNoLimit);
  if (!patient.ok()) return patient.status();
  if (absl::Status ready = MigratePostgres(**patient); !ready.ok()) return ready;
  return std::unique_ptr<PostgresDatabase>(new PostgresDatabase(conninfo, max_connections));
}

absl::Status PostgresDatabase::CheckPulse() const {
  if (!pulse_ || !pulse_->silent()) return absl::OkStatus();
  return StoreAway("PostgreSQL: it has not answered for seconds");
}

absl::StatusOr<SqlSession> PostgresDatabase::Take() {
  if (absl::Status beats = CheckPulse(); !beats.ok()) return beats;
  std::unique_ptr<PostgresConnection> connection;
  {
    std::unique_lock lock(mutex_);
    if (!given_back_.wait_for(lock, kPatience, [this] { return free_ > 0; })) {
      return StoreAway("PostgreSQL: all connections are busy");
    }
    // The pulse may have stopped meanwhile.
    if (absl::Status beats = CheckPulse(); !beats.ok()) return beats;
    --free_;
    if (!idle_.empty()) {
      connection = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (!connection) {
    auto opened = PostgresConnection::Open(conninfo_);
    if (!opened.ok()) {
      GiveBack(nullptr);
      return opened.status();
    }
    connection = *std::move(opened);
  }
  return SqlSession(connection.release(), [this](SqlConnection* used) {
    GiveBack(std::unique_ptr<PostgresConnection>(static_cast<PostgresConnection*>(used)));
  });
}

/// Returns a connection. If it is broken, also drops the idle connections: the server was
/// unreachable, so they are broken as well.
void PostgresDatabase::GiveBack(std::unique_ptr<PostgresConnection> connection) {
  std::vector<std::unique_ptr<PostgresConnection>> broken;
  std::lock_guard lock(mutex_);
  if (connection && connection->alive()) {
    idle_.push_back(std::move(connection));
  } else {
    broken.swap(idle_);
  }
  ++free_;
  given_back_.notify_one();
}

}  // namespace slicefarm::coordinator
