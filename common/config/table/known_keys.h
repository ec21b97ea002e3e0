#pragma once

#include <string_view>

namespace slicefarm::config {

/// A setting of PrusaSlicer's (2.5 to 2.9) that has no effect here.
struct KnownKey {
  std::string_view key;
  std::string_view why;  ///< "not supported yet", ...
  /// With this value nothing is lost, and nothing need be said. `has_neutral` false: there is no
  /// such value.
  std::string_view neutral = {};
  bool has_neutral = false;
  bool of_print = true;  ///< concerns the print at all, not profiles, hosts or other machines
  bool changes_print = false;         ///< the part comes out otherwise than asked: worth a warning
  /// Templates may name it, and the G-code quotes it. Not so for what is nobody's business who gets
  /// the file, such as a print host's password.
  bool told = true;
  bool of_several_extruders = false;  ///< decides between them, and one prints
  /// The print is spoilt without it: a job is refused unless it allows that (missing_feature.h).
  bool spoils_print = false;
};

/// The entry of `key`, or nullptr: not known to PrusaSlicer either, or it has an effect
/// (settings_table.h).
const KnownKey* FindKnownKey(std::string_view key);

/// Whether `value` asks for nothing that is not done: its items all equal the neutral value, as
/// numbers if they are.
bool IsNeutral(const KnownKey& key, std::string_view value);

}  // namespace slicefarm::config
