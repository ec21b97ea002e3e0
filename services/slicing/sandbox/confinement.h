#pragma once

#include "absl/status/status.h"
#include "services/slicing/sandbox/reader_limits.h"

namespace slicefarm::slicing {

/// Degree of confinement of a program.
enum class Confinement {
  kLimits,  ///< resource limits: no new file, socket or process, bounded memory and time
  /// Like kLimits. In addition the kernel kills the program if it makes a system call outside a
  /// short list.
  kStrict,
};

/// Permanently removes all rights from this program that a mesh reader does not need. The program
/// may still write to and close its open files, allocate memory within the limits, and exit. It is
/// killed when the thread of the program `parent` (a process id) that started it ends. It leaves no
/// core file and cannot be traced.
///
/// Call it while the program has only one thread. In a sanitized build (sanitized_build.h) memory
/// is not bounded and a few more system calls are allowed. Errors: FailedPrecondition with the step
/// that the system refused. The program is then only partly confined and should end.
absl::Status Confine(Confinement confinement, const ReaderLimits& limits, int64_t parent);

}  // namespace slicefarm::slicing
