#pragma once

#include "absl/status/status.h"
#include "services/slicing/sandbox/reader_limits.h"

namespace slicefarm::slicing {

/// How far a process is shut in.
enum class Confinement {
  kLimits,  ///< resource limits: no new file, socket or process, bounded memory and time
  kStrict,  ///< and the kernel kills it at any system call but a few
};

/// Takes from this process, for good, all that a mesh reader does not need: what it has open it
/// may still write and close; it gets memory within the limits, and the end. It dies with the
/// thread of `parent` that started it, leaves no core file and cannot be traced.
///
/// Call it in a process with one thread. In a sanitized build (sanitized_build.h) memory is not
/// bounded and some more system calls are let through. Errors: FailedPrecondition naming the step
/// that the system refused; the process is then shut in by halves, and should end.
absl::Status Confine(Confinement confinement, const ReaderLimits& limits, int64_t parent);

}  // namespace slicefarm::slicing
