#pragma once

#include <string_view>

namespace slicefarm::config {

/// Setting of PrusaSlicer (2.5 to 2.9) that has no effect in slicefarm.
struct KnownKey {
  std::string_view key;
  std::string_view why;  ///< reason, such as "not supported yet"
  /// Values that request nothing, separated by `|`: a setting with such a value is not reported.
  /// Only valid if `has_neutral` is true.
  std::string_view neutral = {};
  bool has_neutral = false;
  /// True if the setting concerns the print; false for a setting about profiles, print hosts or
  /// other kinds of machines.
  bool of_print = true;
  /// true if the part differs from the request without the setting: needs a warning
  bool changes_print = false;
  /// True if templates may name the setting and the G-code quotes it. False for private values,
  /// such as the password of a print host: receivers of the file must not get them.
  bool reported = true;
  /// True if the setting concerns the use of several extruders; in slicefarm only one extruder
  /// prints.
  bool of_several_extruders = false;
  /// True if ignoring the setting spoils the print. A job with the setting is then refused unless
  /// it allows the feature to be missing (missing_feature.h).
  bool spoils_print = false;
};

/// Returns the entry of `key`. Returns nullptr if PrusaSlicer does not have the key, or if the key
/// has an effect (settings_table.h).
const KnownKey* FindKnownKey(std::string_view key);

/// Returns true if `value` requests no change of the usual behaviour: each of its items equals a
/// neutral value. Numbers are compared as numbers.
bool IsNeutral(const KnownKey& key, std::string_view value);

}  // namespace slicefarm::config
