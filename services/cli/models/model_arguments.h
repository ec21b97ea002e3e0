#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/scene/placement.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

// Functions that parse and check command-line arguments about models. Errors: REQUEST_MALFORMED
// with the name of the option.

/// Returns the placement that --units, --scale, --rotate, --rotate-z and --center define.
absl::StatusOr<Placement> PlacementOf(const JobOptions& options);

/// Argument for one model or object, in the form `NAME=VALUE` or `NAME:VALUE`.
struct OfModel {
  std::string name;  ///< name of the model or object; empty: the argument begins with no known name
  std::string what;  ///< text after the separator
};

/// Splits an argument into name and value. The name is the longest of the names `known` with which
/// the text begins, because names may contain the separator.
OfModel TakeApart(const std::string& text, char separator, const std::vector<std::string>& known);

/// Returns the number N of --copies NAME=N, from 1 to limits::kMaxObjects. `text`: the argument;
/// `of`: the same argument after TakeApart.
absl::StatusOr<int> CopiesOf(const std::string& text, const OfModel& of);

}  // namespace slicefarm::cli
