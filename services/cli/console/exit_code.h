#pragma once

#include "absl/status/status.h"

namespace slicefarm::cli {

/// Exit codes for scripts. `slicefarm --help` and README.md list them.
enum class ExitCode {
  kOk = 0,
  kInternal = 1,           ///< a bug in slicefarm
  kFindings = 1,           ///< the file that `check` has read has errors
  kUsage = 2,              ///< wrong command line, or an input file that cannot be read
  kBadSettings = 3,        ///< an unknown or malformed setting, or a value out of range
  kBadMesh = 4,            ///< a model that cannot be read, does not fit or has nothing to print
  kServerUnavailable = 5,  ///< no answer from the server, or not in time
  kJobFailed = 6,          ///< the job has failed on the server, or its result is damaged
  kCancelled = 7,          ///< cancelled by Ctrl-C or by another client
  kNotFound = 8,           ///< no such job, or no result (yet)
  kOutputFailed = 9,       ///< the result cannot be written
  kRefusedNow = 10,        ///< the farm refuses jobs at the moment: quota, queue or disk
};

/// Returns the exit code of an error, from its reason.
ExitCode ExitCodeOf(const absl::Status& status);

}  // namespace slicefarm::cli
