#pragma once

#include "absl/status/status.h"

namespace slicefarm::cli {

/// What scripts can tell from how the program ended. `slicefarm --help` and README.md list them.
enum class ExitCode {
  kOk = 0,
  kInternal = 1,           ///< a fault of ours
  kFindings = 1,           ///< of `check`: something is wrong with the file
  kUsage = 2,              ///< wrong command line, or an input file that cannot be read
  kBadSettings = 3,        ///< a setting that is unknown, malformed or out of range
  kBadMesh = 4,            ///< the model cannot be read, does not fit or has nothing to print
  kServerUnavailable = 5,  ///< nobody answers, or not in time
  kJobFailed = 6,          ///< the server gave the job up, or has spoilt bytes
  kCancelled = 7,          ///< by Ctrl-C, or by somebody else
  kNotFound = 8,           ///< no such job, or it has no result (yet)
  kOutputFailed = 9,       ///< the result cannot be written
  kRefusedNow = 10,        ///< the farm has no room at the moment: quota, queue or disk
};

/// The exit code of an error, by its reason.
ExitCode ExitCodeOf(const absl::Status& status);

}  // namespace slicefarm::cli
