#pragma once

#include <sys/types.h>

#include <span>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/sandbox/fd.h"

namespace slicefarm::slicing {

/// Result of a reader program that has ended: exit status and CPU time.
struct ProcessEnd {
  int wait_status = 0;  ///< status as wait(2) returns it
  double cpu_s = 0;
};

/// Reader program that works on one request. The destructor kills the reader if necessary and reaps
/// it. Only the thread that started the reader may use it; the reader dies with this thread.
///
/// The reader has the request as stdin and a pipe as stdout, an empty environment and no other open
/// files. It ignores the signals that tell a service to end, because the service decides if the
/// reader is still needed.
class ReaderProcess {
 public:
  /// Starts `program` (a path) with `request` as its stdin. Safe in a service with many threads.
  /// Errors: Unavailable if the system cannot start the program now.
  static absl::StatusOr<ReaderProcess> Start(const std::string& program, const Fd& request);
  ReaderProcess(ReaderProcess&& other) noexcept;
  ~ReaderProcess();

  /// Fills `bytes` from the reader's stdout. Returns false if the output ended before `bytes` was
  /// full. Errors: Cancelled.
  absl::StatusOr<bool> Receive(std::span<char> bytes, const CancelToken& cancel);

  /// Waits until the reader ends by itself. If the call is cancelled, kills the reader and returns
  /// Cancelled.
  absl::StatusOr<ProcessEnd> AwaitEnd(const CancelToken& cancel);

 private:
  ReaderProcess(pid_t pid, Fd answer) : pid_(pid), answer_(std::move(answer)) {}

  pid_t pid_;  ///< process id; 0: the reader has been reaped
  Fd answer_;
};

}  // namespace slicefarm::slicing
