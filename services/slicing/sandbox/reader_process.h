#pragma once

#include <sys/types.h>

#include <span>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/sandbox/fd.h"

namespace slicefarm::slicing {

/// Exit status of a process and its CPU time.
struct ProcessEnd {
  int wait_status = 0;  ///< status from wait(2)
  double cpu_s = 0;
};

/// Reader program that works on one request. The destructor kills the process if necessary and
/// reaps it. Only the thread that started the process may use it; the process dies with this
/// thread.
///
/// The process has the request as stdin and a pipe as stdout, an empty environment and no other
/// open files. It ignores the signals that tell a service to end, because the service decides if
/// the process is still needed.
class ReaderProcess {
 public:
  /// Starts `program` (a path). Safe in a process with many threads. Errors: Unavailable if the
  /// system cannot start the program now.
  static absl::StatusOr<ReaderProcess> Start(const std::string& program, const Fd& request);
  ReaderProcess(ReaderProcess&& other) noexcept;
  ~ReaderProcess();

  /// Fills `bytes` from the process's stdout; returns false if there were fewer bytes. Errors:
  /// Cancelled.
  absl::StatusOr<bool> Receive(std::span<char> bytes, const CancelToken& cancel);

  /// Waits until the process has ended by itself. Errors: Cancelled; the process is then killed.
  absl::StatusOr<ProcessEnd> AwaitEnd(const CancelToken& cancel);

 private:
  ReaderProcess(pid_t pid, Fd answer) : pid_(pid), answer_(std::move(answer)) {}

  pid_t pid_;  ///< process id; 0: already reaped
  Fd answer_;
};

}  // namespace slicefarm::slicing
