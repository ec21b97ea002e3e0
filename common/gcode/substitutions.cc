#include "common/gcode/substitutions.h"

#include <fmt/core.h>
#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "common/base/text.h"

namespace slicefarm::gcode {
namespace {

constexpr size_t kItems = 4;
constexpr int64_t kMostMemory = 8 << 20;
constexpr size_t kMostGroups = 10;  // the whole match, and groups that a digit can name
constexpr int64_t kMatchesBetweenPolls = 256;

bool HasFlag(std::string_view flags, char flag) {
  return std::ranges::any_of(
      flags, [&](char c) { return std::tolower(static_cast<unsigned char>(c)) == flag; });
}

/// Replaces \n, \r, \t and \\ in a text that is not a regular expression.
std::string Plain(std::string_view text) {
  std::string plain;
  for (size_t i = 0; i < text.size(); ++i) {
    const char next = text[i] == '\\' && i + 1 < text.size() ? text[i + 1] : '\0';
    const size_t known = std::string_view("nrt\\").find(next);
    if (next == '\0' || known == std::string_view::npos) {
      plain += text[i];
      continue;
    }
    plain += "\n\r\t\\"[known];
    ++i;
  }
  return plain;
}

/// Returns a literal text in RE2's notation of replacements.
std::string Literal(std::string_view text) {
  std::string literal;
  for (const char c : text) literal += c == '\\' ? "\\\\" : std::string(1, c);
  return literal;
}

/// Converts PrusaSlicer's `$1`, `$&` and `\n` to RE2's notation.
std::string Format(std::string_view text) {
  std::string format;
  for (size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    const bool digit = std::isdigit(static_cast<unsigned char>(next)) != 0;
    if (text[i] == '$' && digit) {
      format += std::string("\\") + text[++i];
    } else if (text[i] == '$' && (next == '&' || next == '$')) {
      format += next == '&' ? "\\0" : "$";
      ++i;
    } else if (text[i] == '\\' && digit) {
      format += std::string("\\") + text[++i];
    } else if (text[i] == '\\' && next != '\0') {
      ++i;
      format += next == 'n'    ? "\n"
                : next == 'r'  ? "\r"
                : next == 't'  ? "\t"
                : next == '\\' ? "\\\\"
                               : std::string(1, next);
    } else {
      format += text[i] == '\\' ? "\\\\" : std::string(1, text[i]);
    }
  }
  return format;
}

absl::Status BadSubstitution(std::string_view pattern, std::string_view why) {
  return absl::InvalidArgumentError(fmt::format("the substitution of '{:.60}': {}", pattern, why));
}

absl::Status TooLong(size_t most_bytes) {
  return absl::ResourceExhaustedError(
      fmt::format("a rule makes a text of more than {} bytes", most_bytes));
}

/// Returns the end of the UTF-8 character at `begin`; at the end of the text, one byte beyond it.
size_t EndOfCharacter(std::string_view text, size_t begin) {
  size_t end = begin + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
  return end;
}

}  // namespace

absl::StatusOr<Substitutions> Substitutions::Of(const std::vector<std::string>& items) {
  if (items.size() % kItems != 0)
    return absl::InvalidArgumentError(
        "four texts are needed for each: pattern, replacement, flags, notes");
  if (items.size() > kItems * kMostRules)
    return absl::InvalidArgumentError(fmt::format("there are {} rules, at most {} are possible",
                                                  items.size() / kItems, kMostRules));
  Substitutions result;
  for (size_t i = 0; i < items.size(); i += kItems) {
    const std::string& look_for = items[i];
    const std::string& flags = items[i + 2];
    const bool is_regular = HasFlag(flags, 'r');
    if (look_for.empty()) continue;
    re2::RE2::Options options(re2::RE2::Quiet);
    options.set_case_sensitive(!HasFlag(flags, 'i'));
    options.set_dot_nl(HasFlag(flags, 's'));
    options.set_max_mem(kMostMemory);
    const std::string body = is_regular ? look_for : re2::RE2::QuoteMeta(Plain(look_for));
    const std::string word = HasFlag(flags, 'w') ? "\\b" : "";
    auto pattern =
        std::make_shared<re2::RE2>(fmt::format("(?m){0}(?:{1}){0}", word, body), options);
    if (!pattern->ok()) return BadSubstitution(look_for, pattern->error());
    const std::string by = is_regular ? Format(items[i + 1]) : Literal(Plain(items[i + 1]));
    std::string why;
    if (!pattern->CheckRewriteString(by, &why)) return BadSubstitution(look_for, why);
    result.all_.push_back({std::move(pattern), by});
  }
  return result;
}

absl::StatusOr<std::string> Substitutions::Apply(std::string gcode, size_t most_bytes,
                                                 const CancelToken& cancel) const {
  for (const Rule& rule : all_) {
    auto next = Apply(rule, gcode, most_bytes, cancel);
    if (!next.ok()) return next;
    gcode = *std::move(next);
  }
  return gcode;
}

// Replaces all matches like RE2::GlobalReplace, but limits the size of the result and polls the
// token.
absl::StatusOr<std::string> Substitutions::Apply(const Rule& rule, const std::string& gcode,
                                                 size_t most_bytes, const CancelToken& cancel) {
  std::array<re2::StringPiece, kMostGroups> groups;
  const int count = 1 + re2::RE2::MaxSubmatch(rule.replacement);
  std::string result;
  size_t done = 0;
  std::optional<size_t> last_end;
  for (int64_t matches = 0; done <= gcode.size(); ++matches) {
    if (matches % kMatchesBetweenPolls == 0)
      if (absl::Status go_on = cancel.Check(); !go_on.ok()) return go_on;
    if (!rule.pattern->Match(gcode, done, gcode.size(), re2::RE2::UNANCHORED, groups.data(), count))
      break;
    const auto begin = static_cast<size_t>(groups[0].data() - gcode.data());
    result.append(gcode, done, begin - done);
    if (groups[0].empty() && begin == last_end) {  // an empty match directly after the last one
      done = EndOfCharacter(gcode, begin);
      result.append(gcode, begin, done - begin);
    } else {
      rule.pattern->Rewrite(&result, rule.replacement, groups.data(), count);
      done = begin + groups[0].size();
      last_end = done;
    }
    if (result.size() > most_bytes) return TooLong(most_bytes);
  }
  if (done < gcode.size()) result.append(gcode, done);
  return result.size() > most_bytes ? TooLong(most_bytes) : absl::StatusOr<std::string>(result);
}

std::vector<std::string> TextsOfList(std::string_view list) {
  std::vector<std::string> texts;
  std::string_view rest = Trim(list);
  while (!rest.empty()) {
    std::string text;
    const bool quoted = rest[0] == '"';
    size_t end = quoted ? 1 : std::min(rest.find(';'), rest.size());
    if (!quoted) text = std::string(Trim(rest.substr(0, end)));
    for (; quoted && end < rest.size() && rest[end] != '"'; ++end) {
      const bool escapes = rest[end] == '\\' && end + 1 < rest.size();
      const char c = escapes ? rest[++end] : rest[end];
      text += !escapes ? c : c == 'n' ? '\n' : c == 'r' ? '\r' : c;
    }
    texts.push_back(std::move(text));
    const size_t next = rest.find(';', std::min(end, rest.size()));
    if (next == std::string_view::npos) break;
    rest = Trim(rest.substr(next + 1));
    if (rest.empty()) texts.emplace_back();
  }
  return texts;
}

}  // namespace slicefarm::gcode
