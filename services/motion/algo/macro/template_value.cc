#include "services/motion/algo/macro/template_value.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace slicefarm::motion {
namespace {

constexpr int kDecimals = 6;

template <typename Number>
std::optional<Number> Parse(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return number;
}

std::optional<TemplateValue> ParseNumber(std::string_view text) {
  if (const auto whole = Parse<int64_t>(text)) return TemplateValue(*whole);
  if (const auto number = Parse<double>(text); number && std::isfinite(*number)) {
    return TemplateValue(*number);
  }
  return {};
}

std::string NumberText(double number) {
  char buffer[64];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::fixed, kDecimals);
  if (end.ec != std::errc()) return "0";
  std::string text(buffer, end.ptr);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

const TemplateValue* FindValue(const TemplateVariables& variables, std::string_view name,
                               int64_t index) {
  const auto found = variables.find(name);
  if (found == variables.end() || found->second.empty()) return nullptr;
  const std::vector<TemplateValue>& values = found->second;
  const bool inside = 0 <= index && index < static_cast<int64_t>(values.size());
  return &values[inside ? static_cast<size_t>(index) : 0];
}

std::string ToText(const TemplateValue& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* whole = std::get_if<int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return NumberText(*number);
  return std::get<std::string>(value);
}

std::vector<TemplateValue> ParseSetting(std::string_view text) {
  std::vector<TemplateValue> values;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const auto number = ParseNumber(text.substr(begin, end - begin));
    if (!number) return {std::string(text)};
    values.push_back(*number);
    begin = end + 1;
  }
  return values;
}

}  // namespace slicefarm::motion
