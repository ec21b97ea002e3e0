#include "common/config/projects/orca_placeholders.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "common/base/text.h"

namespace slicefarm::config {
namespace {

/// Returns the length of the name, number or quoted text at the start of `text`; 1 for any other
/// character.
size_t TokenSize(std::string_view text) {
  size_t size = 1;
  if (text.front() == '"') {
    while (size < text.size() && text[size] != '"') size += text[size] == '\\' ? 2 : 1;
    return std::min(size + 1, text.size());
  }
  if (!IsOfName(text.front())) return 1;
  while (size < text.size() && IsOfName(text[size])) ++size;
  return size;
}

/// Returns the position after the bracket that closes the bracket at the start of `text`; npos if
/// there is none.
size_t AfterClosing(std::string_view text, char open, char close) {
  int depth = 0;
  for (size_t at = 0; at < text.size(); at += TokenSize(text.substr(at))) {
    if (text[at] == open) ++depth;
    if (text[at] == close && --depth == 0) return at + 1;
  }
  return std::string_view::npos;
}

std::string_view WithoutSpace(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
}

std::string ReplaceInExpression(std::string_view text, const PlaceholderMeaning& meaning) {
  std::string result;
  while (!text.empty()) {
    const std::string_view token = text.substr(0, TokenSize(text));
    text.remove_prefix(token.size());
    const bool is_name = IsOfName(token.front()) && !absl::ascii_isdigit(token.front());
    const std::string_view next = WithoutSpace(text);
    const auto found = is_name && !next.starts_with('(') ? meaning(token) : std::nullopt;
    result += found ? std::string_view(found->text) : token;
    if (!found || found->is_variable || !next.starts_with('[')) continue;
    const size_t end = AfterClosing(next, '[', ']');
    if (end != std::string_view::npos) text = next.substr(end);
  }
  return result;
}

/// Returns the replacement for a text in square brackets. `inside`: text between the brackets. A
/// value is put into braces.
std::string ReplaceInBrackets(std::string_view inside, const PlaceholderMeaning& meaning) {
  const std::string_view name = Trim(inside.substr(0, inside.find('[')));
  const bool is_name = !name.empty() && std::all_of(name.begin(), name.end(), IsOfName);
  const auto found = is_name ? meaning(name) : std::nullopt;
  const bool is_value = found && !found->is_variable;
  const std::string replaced = is_name ? ReplaceInExpression(inside, meaning) : std::string(inside);
  return is_value ? "{" + replaced + "}" : "[" + replaced + "]";
}

}  // namespace

std::string ReplacePlaceholders(std::string_view gcode, const PlaceholderMeaning& meaning) {
  std::string result;
  while (!gcode.empty()) {
    const size_t open = std::min(gcode.find_first_of("[{"), gcode.size());
    result += gcode.substr(0, open);
    gcode.remove_prefix(open);
    if (gcode.empty()) break;
    const bool braces = gcode.front() == '{';
    const size_t end = AfterClosing(gcode, braces ? '{' : '[', braces ? '}' : ']');
    if (end == std::string_view::npos) return result + std::string(gcode);
    const std::string_view inside = gcode.substr(1, end - 2);
    result += braces ? "{" + ReplaceInExpression(inside, meaning) + "}"
                     : ReplaceInBrackets(inside, meaning);
    gcode.remove_prefix(end);
  }
  return result;
}

Placeholder ValuePlaceholder(std::string_view value) {
  if (const auto number = ToNumber(Trim(value))) {
    const std::string text(Trim(value));
    return {*number < 0 ? "(" + text + ")" : text, false};
  }
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    text += c == '\n' ? "\\n" : std::string(1, c);
  }
  return {text + "\"", false};
}

}  // namespace slicefarm::config
