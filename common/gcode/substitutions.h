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

/// Rules that replace texts in G-code: the setting gcode_substitutions.
class Substitutions {
 public:
  static constexpr size_t kMostRules = 64;

  /// Reads the rules. `items`: four texts per rule, in PrusaSlicer's format: pattern, replacement,
  /// flags, notes.
  ///
  /// Flags:
  /// - `r`: the pattern is a regular expression in RE2's syntax, where ^ and $ match the ends of
  ///   lines. The replacement may refer to groups as $1 or \1.
  /// - `i`: ignores letter case.
  /// - `w`: matches whole words.
  /// - `s`: a dot matches a line end as well.
  ///
  /// Without `r`, pattern and replacement may contain \n, \r, \t and \\.
  ///
  /// Errors: InvalidArgument if the number of items is wrong or there are more than kMostRules
  /// rules; if a pattern is invalid or needs too much memory; if a group does not exist.
  static absl::StatusOr<Substitutions> Of(const std::vector<std::string>& items);

  /// Returns true if there are no rules.
  bool empty() const { return all_.empty(); }

  /// Returns `gcode` after all rules, applied one after another. Errors: ResourceExhausted as soon
  /// as a rule makes the text longer than `most_bytes`; Cancelled. Cost per rule: linear in the
  /// length of `gcode` and of the result, unless the pattern has to examine text after its match.
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

/// Returns the items of a list of texts in the format of config.ini: `"a; b";c`, with \n, \r, \"
/// and \\ in quotes.
std::vector<std::string> TextsOfList(std::string_view list);

}  // namespace slicefarm::gcode
