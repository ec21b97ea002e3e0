#include "common/base/text.h"

#include <charconv>
#include <cmath>

namespace slicefarm {

namespace {

/// Returns the length of the control character at the start of the text, in bytes. Returns 0 if the
/// text starts with another character.
size_t ControlBytes(std::string_view text) {
  if (IsControl(text[0])) return 1;
  if (text.size() >= 2 && text[0] == '\xc2' && static_cast<unsigned char>(text[1]) < 0xa0) return 2;
  if (text.starts_with("\u2028") || text.starts_with("\u2029")) return 3;
  return 0;
}

}  // namespace

std::string ReplaceControls(std::string_view text, char with) {
  std::string replaced;
  replaced.reserve(text.size());
  while (!text.empty()) {
    const size_t control = ControlBytes(text);
    replaced += control == 0 ? text[0] : with;
    text.remove_prefix(control == 0 ? 1 : control);
  }
  return replaced;
}

std::string_view Trim(std::string_view text, std::string_view blanks) {
  const size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> Split(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  for (size_t begin = 0;;) {
    const size_t end = text.find_first_of(separators, begin);
    parts.push_back(text.substr(begin, end == std::string_view::npos ? end : end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

std::optional<double> ToNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) {
    return std::nullopt;
  }
  return number;
}

}  // namespace slicefarm
