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

/// Queries a PostgreSQL server every second on a connection of its own. So a server that does not
/// answer is detected, and no other call has to wait for it. The same connection reserves the
/// coordinator's name, which only one program at a time may have. Thread-safe.
class PostgresPulse {
 public:
  /// Time limits of a pulse.
  struct Options {
    std::chrono::milliseconds every{1'000};
    std::chrono::milliseconds silent_after{5'000};
    /// Longest wait until another program releases the name. A killed program releases its name at
    /// once; a program on a lost machine, within 11 s.
    std::chrono::milliseconds name_patience{12'000};
  };

  /// Connects and reserves the name. `name`: name of a coordinator; empty: no name is reserved.
  /// Errors: STORE_FAILED; Unavailable if the server does not answer; FailedPrecondition if another
  /// program has the name.
  static absl::StatusOr<std::unique_ptr<PostgresPulse>> Begin(const std::string& conninfo,
                                                              const std::string& name,
                                                              Options options);
  /// Connects and reserves the name, with the default options.
  static absl::StatusOr<std::unique_ptr<PostgresPulse>> Begin(const std::string& conninfo,
                                                              const std::string& name) {
    return Begin(conninfo, name, Options());
  }

  /// Returns true if the server has not answered for `silent_after`.
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
  std::unique_ptr<PostgresConnection> connection_;  ///< used only by the thread after its start
  bool has_name_ = false;                           ///< true if this connection holds the name
  /// Time of the last answer, by a clock that does not run backwards.
  std::atomic<int64_t> answered_ms_ = 0;
  std::jthread thread_;
};

}  // namespace slicefarm::coordinator
