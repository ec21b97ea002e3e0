#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::config {

/// Replacement for a name in an expression of G-code.
struct Placeholder {
  std::string text;  ///< another name, or a value such as `0.4` or `"PLA"`
  /// True: `text` is a name. False: `text` is a value; then an index after the original name
  /// (`name[0]`) is removed.
  bool is_variable = true;
};

/// Function that returns the replacement of a name, or nullopt for a name that is not replaced.
using PlaceholderMeaning = std::function<std::optional<Placeholder>(std::string_view name)>;

/// Returns G-code in which names in `[name]`, `[name[index]]` and `{expression}` are replaced.
/// Quoted texts, functions and text outside of brackets remain unchanged. A malformed template (a
/// bracket without end) also remains unchanged: its expansion reports the error.
std::string ReplacePlaceholders(std::string_view gcode, const PlaceholderMeaning& meaning);

/// Returns a value as it is written in an expression: `0.4`, `(-1)`, `"Textured PEI Plate"`.
Placeholder ValuePlaceholder(std::string_view value);

}  // namespace slicefarm::config
