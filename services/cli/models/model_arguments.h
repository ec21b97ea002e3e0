#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/scene/placement.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// What the command line says about models, read and checked. Errors: REQUEST_MALFORMED naming the
/// option.

/// --units, --scale, --rotate, --rotate-z and --center.
absl::StatusOr<Placement> PlacementOf(const JobOptions& options);

/// What is said of one model or object: `NAME=...`.
struct OfModel {
  std::string name;  ///< empty: none of the known ones
  std::string what;  ///< after the separator
};

/// Takes the longest of the known names that the text begins with: names may hold the separator.
OfModel TakeApart(const std::string& text, char separator, const std::vector<std::string>& known);

/// The number of --copies NAME=N, from 1 to limits::kMaxObjects.
absl::StatusOr<int> CopiesOf(const std::string& text, const OfModel& of);

}  // namespace slicefarm::cli
