#pragma once

#include "absl/status/status.h"
#include "services/slicing/sandbox/reader_limits.h"

namespace slicefarm::slicing {

/// Degree of confinement of a process.
enum class Confinement {
  kLimits,  ///< resource limits: no new file, socket or process, bounded memory and time
  /// Like kLimits. In addition the kernel kills the process if it makes a system call outside a
  /// short list.
  kStrict,
};

/// Permanently removes all rights from this process that a mesh reader does not need. The process
/// may still write to and close its open files, allocate memory within the limits, and exit. It is
/// killed when the thread of `parent` that started it ends. It leaves no core file and cannot be
/// traced.
///
/// Call it in a process with one thread. In a sanitized build (sanitized_build.h) memory is not
/// bounded and a few more system calls are allowed. Errors: FailedPrecondition with the step that
/// the system refused. The process is then only partly confined and should end.
absl::Status Confine(Confinement confinement, const ReaderLimits& limits, int64_t parent);

}  // namespace slicefarm::slicing
