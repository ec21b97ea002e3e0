#pragma once

#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::motion {

/// Whether the whole of `text` matches a regular expression:
///   .  [a-z] [^a-z]  \d \w \s (and capitals)  \. and the like   one character; a line end is one
///   ( )  (?: )  |                                               groups and alternatives
///   * + ?                                                       repetition
///   ^ $                                                         of no effect: all has to match
///
/// By simulation of an automaton and without backtracking: strangers write both. Cost: O(text *
/// pattern). Errors: InvalidArgument for patterns that cannot be read or are longer than 1000
/// characters. Source: R. Cox, "Regular Expression Matching: the Virtual Machine Approach" (2009).
absl::StatusOr<bool> MatchesPattern(std::string_view text, std::string_view pattern);

}  // namespace slicefarm::motion
