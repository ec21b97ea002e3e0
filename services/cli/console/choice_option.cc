#include "services/cli/console/choice_option.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "absl/strings/str_join.h"
#include "common/base/text.h"
#include "common/config/table/suggest.h"

namespace slicefarm::cli {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::max();

std::string RangeText(double min, double max, bool open_end) {
  if (open_end) return fmt::format("more than {}", min);
  if (max == kUnbounded) return fmt::format("{} or more", min);
  return fmt::format("from {} to {}", min, max);
}

CLI::Validator AtLeast(double min, bool open_end) {
  return CLI::Validator(
      [min, open_end](std::string& text) {
        return FaultOfNumber(text, min, kUnbounded, false, open_end);
      },
      "");
}

}  // namespace

std::string NoSuchChoice(const std::string& text, const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string nearest = config::Nearest(text, views);
  return fmt::format("'{}' is not one of {}{}", text, absl::StrJoin(names, ", "),
                     nearest.empty() ? "" : fmt::format("; do you mean {}?", nearest));
}

std::string ListOf(const std::vector<std::string>& names) {
  return "{" + absl::StrJoin(names, ",") + "}";
}

CLI::Validator OneOf(std::vector<std::string> names) {
  std::string list = ListOf(names);
  return CLI::Validator(
      [names = std::move(names)](std::string& text) {
        const bool known = std::ranges::find(names, text) != names.end();
        return known ? std::string() : NoSuchChoice(text, names);
      },
      std::move(list));
}

std::string FaultOfNumber(const std::string& text, double min, double max, bool whole,
                          bool open_end) {
  const auto number = ToNumber(Trim(text));
  const std::string range = RangeText(min, max, open_end);
  const std::string_view kind = whole ? "a whole number" : "a number";
  if (!number || !std::isfinite(*number))
    return fmt::format("'{}' is not a number: {} {} is needed", text, kind, range);
  const bool outside = *number < min || *number > max || (open_end && *number == min);
  if (outside || (whole && *number != std::floor(*number)))
    return fmt::format("{} is out of range: {} {} is needed", text, kind, range);
  return "";
}

CLI::Validator AboveZero() { return AtLeast(0, true); }
CLI::Validator ZeroOrMore() { return AtLeast(0, false); }

}  // namespace slicefarm::cli
