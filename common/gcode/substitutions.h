#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"

namespace re2 {
class RE2;
}

namespace slicefarm::gcode {

/// Rules that replace texts of G-code by others: the setting gcode_substitutions.
class Substitutions {
 public:
  static constexpr size_t kMostRules = 64;

  /// Reads the rules. `items`: four texts a rule, as PrusaSlicer has them: pattern, replacement,
  /// flags, notes. Flags: `r`, the pattern is a regular expression of RE2's syntax, where ^ and $
  /// are the ends of lines, and the replacement may name its groups as $1 or \1; `i`, upper and
  /// lower case are the same; `w`, whole words; `s`, a dot matches a line end as well. Without `r`
  /// both texts may have \n, \r, \t and \\.
  /// Errors: InvalidArgument for another number of items, for more than kMostRules rules, for a
  /// pattern that is no regular expression or takes too much memory, for a group that it has not.
  static absl::StatusOr<Substitutions> Of(const std::vector<std::string>& items);

  bool empty() const { return all_.empty(); }

  /// Returns `gcode` after one rule after the other. Errors: ResourceExhausted as soon as a rule
  /// makes the text longer than `most_bytes`; Cancelled. Cost: linear in the text and in the
  /// replaced text for each rule, for patterns that need not look beyond their match.
  absl::StatusOr<std::string> Apply(std::string gcode, size_t most_bytes,
                                    const CancelToken& cancel) const;

 private:
  struct Rule {
    std::shared_ptr<const re2::RE2> pattern;
    std::string replacement;  ///< in RE2's notation
  };

  static absl::StatusOr<std::string> Apply(const Rule& rule, const std::string& gcode,
                                           size_t most_bytes, const CancelToken& cancel);

  std::vector<Rule> all_;
};

/// The items of a list of texts as a config.ini has it: `"a; b";c`, with \n, \r, \" and \\ in
/// quotes.
std::vector<std::string> TextsOfList(std::string_view list);

}  // namespace slicefarm::gcode
