#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/scene/placement.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// Command-line arguments about models, parsed and checked. Errors: REQUEST_MALFORMED naming the
/// option.

/// Returns the placement of --units, --scale, --rotate, --rotate-z and --center.
absl::StatusOr<Placement> PlacementOf(const JobOptions& options);

/// Argument for one model or object, in the form `NAME=...`.
struct OfModel {
  std::string name;  ///< empty: no known name
  std::string what;  ///< text after the separator
};

/// Splits the text after the longest known name at its beginning, because names may contain the
/// separator.
OfModel TakeApart(const std::string& text, char separator, const std::vector<std::string>& known);

/// Returns the number of --copies NAME=N, from 1 to limits::kMaxObjects.
absl::StatusOr<int> CopiesOf(const std::string& text, const OfModel& of);

}  // namespace slicefarm::cli
