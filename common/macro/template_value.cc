#include "common/macro/template_value.h"

#include <charconv>

namespace slicefarm::macro {
namespace {

constexpr int kSignificantDigits = 6;

std::string NumberText(double number) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::general,
                                 kSignificantDigits);
  const std::string text(buffer, end.ptr);
  return text == "-0" ? "0" : text;
}

}  // namespace

const TemplateValue* ItemOf(const TemplateVariable& variable, int64_t index) {
  if (variable.items.empty()) return nullptr;
  const bool inside = 0 <= index && index < static_cast<int64_t>(variable.items.size());
  return &variable.items[inside ? static_cast<size_t>(index) : 0];
}

bool IsUnknown(const TemplateValue& value) { return std::holds_alternative<Unknown>(value); }

std::string ToText(const TemplateValue& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* whole = std::get_if<int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return NumberText(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return {};
}

}  // namespace slicefarm::macro
