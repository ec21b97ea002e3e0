#include "services/coordinator/store/sql/postgres_pulse.h"

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/stoppable_sleep.h"
#include "common/base/stopwatch.h"

namespace slicefarm::coordinator {
namespace {

constexpr std::chrono::milliseconds kAskForNameEvery{100};

/// Settings by which the server detects a lost machine of a coordinator and then releases its name.
constexpr char kKeepalives[] =
    "SET tcp_keepalives_idle = 5; SET tcp_keepalives_interval = 2; SET tcp_keepalives_count = 3; "
    "SET tcp_user_timeout = 10000";

int64_t SteadyMs() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

absl::StatusOr<std::unique_ptr<PostgresPulse>> PostgresPulse::Begin(const std::string& conninfo,
                                                                    const std::string& name,
                                                                    Options options) {
  std::unique_ptr<PostgresPulse> pulse(new PostgresPulse(conninfo, name, options));
  if (absl::Status connected = pulse->Connect(); !connected.ok()) return connected;
  if (absl::Status taken = pulse->AwaitName(); !taken.ok()) return taken;
  pulse->answered_ms_ = SteadyMs();
  pulse->thread_ = std::jthread([self = pulse.get()](const std::stop_token& stop) {
    while (SleepUnlessStopped(stop, self->options_.every))
      if (self->Beat()) self->answered_ms_ = SteadyMs();
  });
  return pulse;
}

bool PostgresPulse::silent() const {
  return SteadyMs() - answered_ms_ > options_.silent_after.count();
}

absl::Status PostgresPulse::Connect() {
  has_name_ = false;
  auto opened = PostgresConnection::Open(conninfo_, options_.silent_after);
  if (!opened.ok()) return opened.status();
  connection_ = *std::move(opened);
  return connection_->Execute(kKeepalives);
}

absl::StatusOr<bool> PostgresPulse::TakeName() {
  if (name_.empty()) return true;
  // The name is unique per schema, because several farms may share a database with a schema each.
  SqlQuery query(*connection_,
                 "SELECT pg_try_advisory_lock(hashtextextended("
                 "coalesce(current_schema()::TEXT, '') || '/' || ?::TEXT, 5117320))");
  query.Bind(name_);
  const bool taken = query.Next() && query.Int(0) != 0;
  if (!query.status().ok()) return query.status();
  return taken;
}

absl::Status PostgresPulse::AwaitName() {
  const Stopwatch since;
  while (true) {
    const auto taken = TakeName();
    if (!taken.ok()) return taken.status();
    has_name_ = *taken;
    if (has_name_) return absl::OkStatus();
    if (since.Seconds() * 1000 >= static_cast<double>(options_.name_patience.count())) {
      return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kStoreFailed,
                       absl::StrCat("another coordinator with the name '", name_,
                                    "' works with this database: give each its own --name"));
    }
    std::this_thread::sleep_for(kAskForNameEvery);
  }
}

/// Sends one query. Returns true if the server answered. Opens a broken connection again and takes
/// the name again.
bool PostgresPulse::Beat() {
  if (!connection_->alive() && !Connect().ok()) return false;
  if (!has_name_) {
    const auto taken = TakeName();
    has_name_ = taken.ok() && *taken;
    return taken.ok();
  }
  return connection_->Execute("SELECT 1").ok();
}

}  // namespace slicefarm::coordinator
