#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include "absl/status/statusor.h"
#include "services/coordinator/store/sql/postgres_connection.h"

namespace slicefarm::coordinator {

/// Asks a PostgreSQL server again and again whether it still answers, on a connection of its own,
/// so that nobody else has to wait for one that stands still. The same connection holds the name of
/// a coordinator: there is one of a name at a time. Thread-safe.
class PostgresPulse {
 public:
  struct Options {
    std::chrono::milliseconds every{1'000};
    std::chrono::milliseconds silent_after{5'000};
    /// With another process that has the name. One that was killed loses it at once; one whose
    /// machine is gone, within 11 s.
    std::chrono::milliseconds name_patience{12'000};
  };

  /// `name`: of a coordinator; empty: none is held. Errors: STORE_FAILED, Unavailable if the server
  /// does not answer, FailedPrecondition if another process has the name.
  static absl::StatusOr<std::unique_ptr<PostgresPulse>> Begin(const std::string& conninfo,
                                                              const std::string& name,
                                                              Options options);
  static absl::StatusOr<std::unique_ptr<PostgresPulse>> Begin(const std::string& conninfo,
                                                              const std::string& name) {
    return Begin(conninfo, name, Options());
  }

  /// True if no question was answered for `silent_after`.
  bool silent() const;

 private:
  PostgresPulse(std::string conninfo, std::string name, Options options)
      : conninfo_(std::move(conninfo)), name_(std::move(name)), options_(options) {}
  absl::Status Connect();
  absl::StatusOr<bool> TakeName();
  absl::Status AwaitName();
  bool Beat();

  const std::string conninfo_;
  const std::string name_;
  const Options options_;
  std::unique_ptr<PostgresConnection> connection_;  ///< of the thread, once that runs
  bool has_name_ = false;                           ///< on this connection
  std::atomic<int64_t> answered_ms_ = 0;            ///< of a clock that does not run backwards
  std::jthread thread_;
};

}  // namespace slicefarm::coordinator
