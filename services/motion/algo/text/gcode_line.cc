#include "services/motion/algo/text/gcode_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "absl/strings/ascii.h"
#include "common/base/text.h"

namespace slicefarm::motion {
namespace {

constexpr double kFarthest = 1e9;

bool IsBlank(char c) { return c == ' ' || c == '\t'; }
bool IsLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
char Upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string_view SkipBlanks(std::string_view text) {
  while (!text.empty() && IsBlank(text.front())) text.remove_prefix(1);
  return text;
}

/// Returns true for commands with text after them: messages, files, names.
bool TakesText(const GcodeLine& line) {
  if (line.letter != 'M') return false;
  switch (line.number) {
    case 0:
    case 1:
    case 16:
    case 20:
    case 22:
    case 23:
    case 28:
    case 30:
    case 32:
    case 33:
    case 36:
    case 98:
    case 115:
    case 117:
    case 118:
    case 291:
    case 292:
    case 486:
    case 550:
    case 551:
    case 552:
    case 555:
    case 559:
    case 560:
    case 587:
    case 624:
    case 862:
    case 928:
    case 1002:
      return true;
    default:
      return false;
  }
}

/// Removes the number at the front of `text` and stores it in `value`. The sign may be `+`. Returns
/// false if there is no number.
bool TakeNumber(std::string_view& text, double& value) {
  const char* from = text.data();
  const char* const end = from + text.size();
  if (from != end && *from == '+') ++from;
  // Accepts only digits, a point and a sign, because from_chars would also read texts such as "inf"
  // and "1e5".
  const char* to = from;
  if (to != end && *to == '-') ++to;
  while (to != end && (absl::ascii_isdigit(*to) || *to == '.')) ++to;
  const auto [after, error] = std::from_chars(from, to, value, std::chars_format::fixed);
  if (error != std::errc() || after != to) return false;
  text.remove_prefix(static_cast<size_t>(after - text.data()));
  return true;
}

}  // namespace

void GcodeLine::ReadWords(std::string_view text) {
  for (text = SkipBlanks(text); !text.empty(); text = SkipBlanks(text)) {
    if (!IsLetter(text.front())) {
      fault = "a word does not begin with a letter";
      return;
    }
    const char word = Upper(text.front());
    text = SkipBlanks(text.substr(1));
    if (Has(word)) {
      fault = kWordTwice;
      return;
    }
    present_ |= Bit(word);
    if (text.empty() || IsLetter(text.front())) continue;
    if (text.front() == '"') {
      const size_t end = text.find('"', 1);
      if (end == text.npos) {
        fault = "a quoted text has no end";
        return;
      }
      has_lists = true;
      text.remove_prefix(end + 1);
      continue;
    }
    double& value = values_[static_cast<size_t>(word - 'A')];
    if (!TakeNumber(text, value)) {
      fault = "the number of a word cannot be read";
      return;
    }
    if (!(std::abs(value) <= kFarthest)) {
      fault = "a number is beyond 1e9";
      return;
    }
    valued_ |= Bit(word);
    for (double next = 0; text.starts_with(':'); has_lists = true) {
      text.remove_prefix(1);
      if (TakeNumber(text, next)) continue;
      fault = "the number of a list cannot be read";
      return;
    }
  }
}

std::optional<std::string_view> GcodeLine::Named(std::string_view name) const {
  for (const std::string_view part : Split(parameters, " \t")) {
    const size_t sign = part.find('=');
    if (sign == part.npos || sign != name.size()) continue;
    if (std::ranges::equal(part.substr(0, sign), name,
                           [](char a, char b) { return Upper(a) == b; }))
      return part.substr(sign + 1);
  }
  return std::nullopt;
}

std::optional<double> GcodeLine::NamedNumber(std::string_view name) const {
  const auto text = Named(name);
  return text ? ToNumber(*text) : std::nullopt;
}

GcodeLine ParseGcodeLine(std::string_view line) {
  GcodeLine result;
  if (const size_t semicolon = line.find(';'); semicolon != line.npos) {
    result.comment = line.substr(semicolon + 1);
    line = line.substr(0, semicolon);
  }
  line = Trim(line);
  if (!line.empty() && Upper(line.front()) == 'N' && line.size() > 1 &&
      absl::ascii_isdigit(line[1])) {
    line.remove_prefix(std::min(line.find_first_not_of("0123456789", 1), line.size()));
    line = SkipBlanks(line.substr(0, line.rfind('*')));
  }
  if (line.empty()) return result;
  size_t end = 1;
  if (IsLetter(line.front()) && line.size() > 1 && absl::ascii_isdigit(line[1])) {
    result.letter = Upper(line.front());
    while (end < line.size() && (absl::ascii_isdigit(line[end]) || line[end] == '.')) ++end;
    std::from_chars(line.data() + 1, line.data() + end, result.number);
  } else if (Upper(line.front()) == 'T' && line.size() == 2) {
    result.letter = 'T';  // commands T?, Tx, Tc of Prusa's multi-material unit
    end = line.size();
  } else {
    while (end < line.size() && !IsBlank(line[end])) ++end;
  }
  result.command = line.substr(0, end);
  result.parameters = Trim(line.substr(end));
  if (result.letter != 0 && !TakesText(result)) result.ReadWords(result.parameters);
  return result;
}

}  // namespace slicefarm::motion
