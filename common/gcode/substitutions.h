#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace re2 {
class RE2;
}

namespace slicefarm::gcode {

/// Texts of G-code that are replaced by others: gcode_substitutions.
class Substitutions {
 public:
  /// `items`: four for each, as PrusaSlicer has them: what is looked for, what takes its place,
  /// flags, notes. Flags: `r`, the first is a regular expression of RE2's syntax, where ^ and $ are
  /// the ends of lines, and the second may name its groups as $1 or \1; `i`, whatever the case;
  /// `w`, whole words; `s`, a dot is a line end as well. Without `r` the texts may have \n, \r, \t
  /// and \\.
  /// Errors: InvalidArgument for another number of items, for what is no regular expression or
  /// takes too long to look for, for a group that it has not.
  static absl::StatusOr<Substitutions> Of(const std::vector<std::string>& items);

  bool empty() const { return all_.empty(); }

  /// One after the other on all of `gcode`. Cost: linear in the text for each.
  std::string Apply(std::string gcode) const;

 private:
  struct One {
    std::shared_ptr<const re2::RE2> pattern;
    std::string by;
  };
  std::vector<One> all_;
};

/// The items of a list of texts as a config.ini has it: `"a; b";c`, with \n, \r, \" and \\ in
/// quotes.
std::vector<std::string> TextsOfList(std::string_view list);

}  // namespace slicefarm::gcode
