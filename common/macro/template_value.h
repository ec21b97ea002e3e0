#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace slicefarm::macro {

/// A setting that its list leaves open (`nil`).
struct Nil {
  friend bool operator==(Nil, Nil) { return true; }
};

/// What only the print itself will tell, while templates are checked before it.
struct Unknown {
  friend bool operator==(Unknown, Unknown) { return true; }
};

/// A value in a G-code template.
using TemplateValue = std::variant<Nil, Unknown, bool, int64_t, double, std::string>;

/// What a name in a template stands for: a value, or a list of them.
struct TemplateVariable {
  TemplateVariable() = default;
  /// One value: `TemplateVariable(int64_t{3})`.
  template <typename Item>
  requires std::is_constructible_v<TemplateValue, Item> TemplateVariable(Item item)
      : items{TemplateValue(std::move(item))} {}  // NOLINT: reads as one
  static TemplateVariable List(std::vector<TemplateValue> items) {
    TemplateVariable list;
    list.items = std::move(items);
    list.is_list = true;
    return list;
  }

  std::vector<TemplateValue> items;
  bool is_list = false;
  /// Of each item, how `[name]` writes it where that differs from its value: "15%". Empty: as
  /// ToText has it.
  std::vector<std::string> written = {};

  friend bool operator==(const TemplateVariable&, const TemplateVariable&) = default;
};

using TemplateVariables = std::map<std::string, TemplateVariable, std::less<>>;

/// Item `index` of a variable; past its end, the first one. nullptr: it has none.
const TemplateValue* ItemOf(const TemplateVariable& variable, int64_t index);

bool IsUnknown(const TemplateValue& value);

/// As it stands in the G-code: numbers with six significant digits, as C's %g has them; nothing for
/// what is unknown.
std::string ToText(const TemplateValue& value);

}  // namespace slicefarm::macro
