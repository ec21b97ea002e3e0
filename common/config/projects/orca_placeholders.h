#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::config {

/// What stands for a name in an expression of G-code.
struct Placeholder {
  std::string text;         ///< another name, or a value: `0.4`, `"PLA"`
  bool is_variable = true;  ///< else it is a value: an index after the name goes
};

/// What a name means; nothing: it stays as it is.
using PlaceholderMeaning = std::function<std::optional<Placeholder>(std::string_view name)>;

/// G-code whose names in `[name]`, `[name[index]]` and `{expression}` are replaced by their
/// meanings. Texts in quotes, functions and all outside of brackets stay. What is no template of
/// PrusaSlicer's (a bracket without end) stays as well: who expands it says so.
std::string ReplacePlaceholders(std::string_view gcode, const PlaceholderMeaning& meaning);

/// A value in an expression: `0.4`, `(-1)`, `"Textured PEI Plate"`.
Placeholder ValuePlaceholder(std::string_view value);

}  // namespace slicefarm::config
