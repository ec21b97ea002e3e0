#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::cli {

/// Reference to a profile or a bundle of presets on the farm.
struct RevisionRef {
  std::string name;
  int64_t revision = 0;  ///< 0: the newest revision

  friend bool operator==(const RevisionRef&, const RevisionRef&) = default;
};

/// Parses `NAME` or `NAME@REVISION`, the form that the farm's commands print. Errors:
/// REQUEST_MALFORMED if there is no whole number above 0 after the `@`.
absl::StatusOr<RevisionRef> ParseRevisionRef(std::string_view text);

}  // namespace slicefarm::cli
