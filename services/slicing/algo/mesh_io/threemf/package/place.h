#pragma once

#include <cstdint>
#include <string>

#include "absl/status/status.h"

namespace slicefarm::slicing::threemf {

/// Where something stands, for errors that show only once all is read.
struct Place {
  std::string part;
  int64_t line = 0;
};

/// `error` with a place: metadata `part` and `line`, and "(PART, line N)".
absl::Status PlacedAt(const Place& place, const absl::Status& error);

}  // namespace slicefarm::slicing::threemf
