#pragma once

#include <cstdint>
#include <string>

#include "absl/status/status.h"

namespace slicefarm::slicing::threemf {

/// Location in a file of an archive, for errors that are detected after the XML is parsed.
struct FileLocation {
  std::string part;
  int64_t line = 0;
};

/// Returns `error` with its location: metadata `part` and `line`, and "(PART, line N)" in the text.
absl::Status WithLocation(const FileLocation& location, const absl::Status& error);

}  // namespace slicefarm::slicing::threemf
