#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace slicefarm::macro {

/// Item of a setting that has no value (`nil`).
struct Nil {
  friend bool operator==(Nil, Nil) { return true; }
};

/// Value that only the print determines. It is used while templates are checked before the print.
struct Unknown {
  friend bool operator==(Unknown, Unknown) { return true; }
};

/// A value in a G-code template.
using TemplateValue = std::variant<Nil, Unknown, bool, int64_t, double, std::string>;

/// Value of a name in a template: a single value, or a list of values.
struct TemplateVariable {
  TemplateVariable() = default;
  /// Makes a variable with one value: `TemplateVariable(int64_t{3})`.
  template <typename Item>
  requires std::is_constructible_v<TemplateValue, Item> TemplateVariable(Item item)
      : items{TemplateValue(std::move(item))} {}  // NOLINT: reads as one
  /// Makes a variable with a list of values.
  static TemplateVariable List(std::vector<TemplateValue> items) {
    TemplateVariable list;
    list.items = std::move(items);
    list.is_list = true;
    return list;
  }

  std::vector<TemplateValue> items;
  bool is_list = false;
  /// Text that `[name]` prints for each item, if it differs from the value, such as "15%". Empty:
  /// the texts of ToText.
  std::vector<std::string> written = {};

  friend bool operator==(const TemplateVariable&, const TemplateVariable&) = default;
};

using TemplateVariables = std::map<std::string, TemplateVariable, std::less<>>;

/// Returns item `index` of a variable; the first item if `index` is past the end; nullptr if the
/// variable has no items.
const TemplateValue* ItemOf(const TemplateVariable& variable, int64_t index);

/// Returns true if the value is Unknown.
bool IsUnknown(const TemplateValue& value);

/// Returns the text of a value in G-code: numbers with six significant digits, as with %g in C; an
/// empty text for an unknown value.
std::string ToText(const TemplateValue& value);

}  // namespace slicefarm::macro
