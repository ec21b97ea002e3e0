#pragma once

#include "absl/status/status.h"
#include "services/slicing/sandbox/reader_limits.h"

namespace slicefarm::slicing {

/// Degree of confinement of a process.
enum class Confinement {
  kLimits,  ///< resource limits: no new file, socket or process, bounded memory and time
  /// Like kLimits; in addition the kernel kills the process at any system call except a few.
  kStrict,
};

/// Removes from this process, permanently, all rights that a mesh reader does not need. It may
/// still write to and close its open files, get memory within the limits, and end. It dies with the
/// thread of `parent` that started it, leaves no core file and cannot be traced.
///
/// Call it in a process with one thread. In a sanitized build (sanitized_build.h) memory is not
/// bounded and a few more system calls are allowed. Errors: FailedPrecondition with the step that
/// the system refused. The process is then only partly confined and should end.
absl::Status Confine(Confinement confinement, const ReaderLimits& limits, int64_t parent);

}  // namespace slicefarm::slicing
