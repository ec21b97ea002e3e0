#pragma once

#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::macro {

/// Whether the whole of `text` matches a regular expression, as PrusaSlicer's =~ has it: Perl's
/// syntax, `.` takes line ends too, `^` and `$` stand for the ends of lines, capitals count. Texts
/// are bytes: a letter beyond ASCII is as many characters as it has bytes.
///
/// By RE2, in time and memory that are linear in the text: strangers write both. So no back
/// references (`\1`) and no looking ahead. Errors: InvalidArgument for patterns that RE2 does not
/// take, that are longer than 1000 characters, or whose repetitions (`x{1000}`) make them large.
absl::StatusOr<bool> MatchesPattern(std::string_view text, std::string_view pattern);

}  // namespace slicefarm::macro
