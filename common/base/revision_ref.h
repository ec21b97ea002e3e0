#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm {

/// Reference to a profile or a bundle of presets on the farm.
struct RevisionRef {
  std::string name;
  int64_t revision = 0;  ///< 0: the newest revision

  friend bool operator==(const RevisionRef&, const RevisionRef&) = default;
};

/// Parses `NAME` or `NAME@REVISION`, the form in which revisions are printed. The name is not
/// checked. Errors: REQUEST_MALFORMED if there is no whole number above 0 after the last `@`.
absl::StatusOr<RevisionRef> ParseRevisionRef(std::string_view text);

}  // namespace slicefarm
