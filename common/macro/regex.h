#pragma once

#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::macro {

/// Returns true if the whole of `text` matches a regular expression, as with PrusaSlicer's =~:
/// Perl's syntax, `.` also matches line ends, `^` and `$` match the ends of lines, and letter case
/// counts. Texts are bytes: a letter beyond ASCII counts as several characters.
///
/// RE2 evaluates the pattern in time and memory that are linear in the text, because strangers
/// write both the pattern and the text. Therefore back references (`\1`) and lookahead are not
/// supported. Errors: InvalidArgument for patterns that RE2 refuses, that are longer than 1000
/// characters, or that are large because of repetitions (`x{1000}`).
absl::StatusOr<bool> MatchesPattern(std::string_view text, std::string_view pattern);

}  // namespace slicefarm::macro
