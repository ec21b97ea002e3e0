#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace slicefarm::motion {

/// A value in a G-code template: a truth value, a whole number, a number or text.
using TemplateValue = std::variant<bool, int64_t, double, std::string>;

/// What a template may name. Each variable is a list; its first element is the variable's value
/// without an index.
using TemplateVariables = std::map<std::string, std::vector<TemplateValue>, std::less<>>;

/// variable[index]; past the list's end, its first element. nullptr: there is no such variable, or
/// it has no value.
const TemplateValue* FindValue(const TemplateVariables& variables, std::string_view name,
                               int64_t index);

/// As it stands in the G-code: numbers without trailing zeros, up to 6 decimals.
std::string ToText(const TemplateValue& value);

/// "210" is a whole number, "0.2" a number, "210,215" a list, anything else text.
std::vector<TemplateValue> ParseSetting(std::string_view text);

}  // namespace slicefarm::motion
