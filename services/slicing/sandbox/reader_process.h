#pragma once

#include <sys/types.h>

#include <span>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/sandbox/fd.h"

namespace slicefarm::slicing {

/// How a process ended, and what it had used by then.
struct ProcessEnd {
  int wait_status = 0;  ///< as of wait(2)
  double cpu_s = 0;
};

/// A reader program at work on one request. Killed, if need be, and reaped when it goes out of
/// scope. To be used by the thread that started it, with which it dies.
///
/// It has the request as stdin, a pipe as stdout, none of the environment and nothing else open,
/// and is deaf to the signals that tell a service to end: whether its work is still wanted is the
/// service's affair.
class ReaderProcess {
 public:
  /// `program`: its path. Safe in a process with many threads. Errors: Unavailable if the system
  /// cannot start it (now).
  static absl::StatusOr<ReaderProcess> Start(const std::string& program, const Fd& request);
  ReaderProcess(ReaderProcess&& other) noexcept;
  ~ReaderProcess();

  /// Fills `bytes` with what comes from its stdout; false if less came. Errors: Cancelled.
  absl::StatusOr<bool> Receive(std::span<char> bytes, const CancelToken& cancel);

  /// Waits until it has ended by itself. Errors: Cancelled, and then it is killed.
  absl::StatusOr<ProcessEnd> AwaitEnd(const CancelToken& cancel);

 private:
  ReaderProcess(pid_t pid, Fd answer) : pid_(pid), answer_(std::move(answer)) {}

  pid_t pid_;  ///< 0: reaped
  Fd answer_;
};

}  // namespace slicefarm::slicing
