#include "common/macro/template_arithmetic.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "absl/strings/str_format.h"
#include "common/macro/regex.h"
#include "common/model/limits.h"

namespace slicefarm::macro {
namespace {

constexpr int64_t kMostDigits = 64;
constexpr double kMostWhole = 1e15;
/// Tolerance of comparisons. Tables also accept values this far beyond their ends.
constexpr double kEqual = 1e-8;
constexpr double kNear = 1e-4;

absl::Status WrongType(std::string_view op) {
  return absl::InvalidArgumentError("operands of the wrong type for \"" + std::string(op) + "\"");
}

std::optional<double> Number(const TemplateValue& value) {
  if (const auto* whole = std::get_if<int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return {};
}

template <typename T>
bool AreEqual(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, double>) return std::abs(a - b) < kEqual;
  return a == b;
}

template <typename T>
bool Compare(std::string_view op, const T& a, const T& b) {
  if (op == "==") return AreEqual(a, b);
  if (op == "!=" || op == "<>") return !AreEqual(a, b);
  if (op == "<") return a < b;
  if (op == "<=") return a <= b;
  if (op == ">") return a > b;
  return a >= b;
}

bool IsComparison(std::string_view op) {
  return op == "==" || op == "!=" || op == "<>" || op == "<" || op == "<=" || op == ">" ||
         op == ">=";
}

absl::StatusOr<TemplateValue> ApplyWhole(std::string_view op, int64_t a, int64_t b) {
  int64_t result = 0;
  bool overflow = false;
  if (op == "+") {
    overflow = __builtin_add_overflow(a, b, &result);
  } else if (op == "-") {
    overflow = __builtin_sub_overflow(a, b, &result);
  } else if (op == "*") {
    overflow = __builtin_mul_overflow(a, b, &result);
  } else {
    if (b == 0) return absl::InvalidArgumentError("division by zero");
    overflow = b == -1 && a == INT64_MIN;
    if (!overflow) result = op == "/" ? a / b : a % b;
  }
  if (overflow) return absl::InvalidArgumentError("number too large");
  return TemplateValue(result);
}

absl::StatusOr<TemplateValue> ApplyReal(std::string_view op, double a, double b) {
  if ((op == "/" || op == "%") && b == 0) return absl::InvalidArgumentError("division by zero");
  if (op == "+") return TemplateValue(a + b);
  if (op == "-") return TemplateValue(a - b);
  if (op == "*") return TemplateValue(a * b);
  return TemplateValue(op == "/" ? a / b : std::fmod(a, b));
}

absl::StatusOr<TemplateValue> ToWhole(const TemplateValue& value, std::string_view function) {
  if (std::holds_alternative<int64_t>(value)) return value;
  const auto number = Number(value);
  if (!number) return WrongType(function);
  if (!(std::abs(*number) < kMostWhole)) return absl::InvalidArgumentError("number too large");
  return TemplateValue(static_cast<int64_t>(function == "round" ? std::round(*number) : *number));
}

/// Formats a number: digits(5, 3) is "  5", zdigits(5, 3) "005", digits(1.25, 5, 1) "  1.2".
absl::StatusOr<TemplateValue> Digits(std::span<const TemplateValue> arguments, bool zeros) {
  const auto value = Number(arguments[0]);
  const auto* width = std::get_if<int64_t>(&arguments[1]);
  const auto* decimals = arguments.size() > 2 ? std::get_if<int64_t>(&arguments[2]) : nullptr;
  if (!value || width == nullptr || (arguments.size() > 2 && decimals == nullptr))
    return WrongType("digits");
  if (!(std::abs(*value) < kMostWhole)) return absl::InvalidArgumentError("digits out of range");
  const int w = static_cast<int>(std::clamp<int64_t>(*width, 0, kMostDigits));
  if (decimals == nullptr) {
    const auto whole = static_cast<int64_t>(std::round(*value));
    return TemplateValue(zeros ? absl::StrFormat("%0*d", w, whole)
                               : absl::StrFormat("%*d", w, whole));
  }
  const int d = static_cast<int>(std::clamp<int64_t>(*decimals, 0, kMostDigits));
  return TemplateValue(zeros ? absl::StrFormat("%0*.*f", w, d, *value)
                             : absl::StrFormat("%*.*f", w, d, *value));
}

/// Returns min or max: an integer if both arguments are integers, otherwise a real number.
absl::StatusOr<TemplateValue> Extreme(const TemplateValue& a, const TemplateValue& b, bool least) {
  const auto x = Number(a);
  const auto y = Number(b);
  if (!x || !y) return WrongType(least ? "min" : "max");
  const bool whole = std::holds_alternative<int64_t>(a) && std::holds_alternative<int64_t>(b);
  if (whole) return (*x < *y) == least ? a : b;
  return TemplateValue(least ? std::min(*x, *y) : std::max(*x, *y));
}

/// Interpolates linearly between points with increasing x.
absl::StatusOr<TemplateValue> Interpolated(std::span<const TemplateValue> arguments) {
  std::vector<double> numbers;
  for (const TemplateValue& argument : arguments) {
    const auto number = Number(argument);
    if (!number) return WrongType("interpolate_table");
    numbers.push_back(*number);
  }
  const double x = numbers[0];
  for (size_t i = 3; i < numbers.size(); i += 2) {
    const double x0 = numbers[i - 2], y0 = numbers[i - 1], x1 = numbers[i], y1 = numbers[i + 1];
    if (x0 > x1) return absl::InvalidArgumentError("the x values of a table must increase");
    if (x < x0 || x > x1) continue;
    if (x == x0 || x0 == x1) return TemplateValue(y0);
    return TemplateValue(x == x1 ? y1 : y0 + (y1 - y0) * ((x - x0) / (x1 - x0)));
  }
  const double last = numbers[numbers.size() - 2];
  if (numbers[1] - kNear < x && x <= numbers[1]) return TemplateValue(numbers[2]);
  if (last <= x && x < last + kNear) return TemplateValue(numbers.back());
  return absl::InvalidArgumentError("interpolate_table: " + ToText(arguments[0]) +
                                    " is outside the table");
}

absl::StatusOr<TemplateValue> IsOneOf(std::span<const TemplateValue> arguments,
                                      std::span<const bool> patterns) {
  const auto* subject = std::get_if<std::string>(&arguments[0]);
  if (subject == nullptr) return WrongType("one_of");
  for (size_t i = 1; i < arguments.size(); ++i) {
    const auto* other = std::get_if<std::string>(&arguments[i]);
    if (other == nullptr) return WrongType("one_of");
    const auto matches = patterns[i] ? MatchesPattern(*subject, *other) : *subject == *other;
    if (!matches.ok()) return matches.status();
    if (*matches) return TemplateValue(true);
  }
  return TemplateValue(false);
}

absl::StatusOr<TemplateValue> Joined(TemplateValue a, const TemplateValue& b) {
  auto* text_a = std::get_if<std::string>(&a);
  std::string joined = text_a != nullptr ? std::move(*text_a) : ToText(a);
  joined += ToText(b);
  if (joined.size() > static_cast<size_t>(limits::kMaxExpandedBytes)) {
    return absl::ResourceExhaustedError("text too long");
  }
  return TemplateValue(std::move(joined));
}

}  // namespace

absl::StatusOr<TemplateValue> Apply(std::string_view op, TemplateValue a, const TemplateValue& b) {
  const auto* text_a = std::get_if<std::string>(&a);
  const auto* text_b = std::get_if<std::string>(&b);
  if (op == "=~" || op == "!~") {
    if (text_a == nullptr || text_b == nullptr) return WrongType(op);
    const auto matches = MatchesPattern(*text_a, *text_b);
    if (!matches.ok()) return matches.status();
    return TemplateValue(*matches == (op == "=~"));
  }
  if (text_a != nullptr || text_b != nullptr) {
    if (op == "+") return Joined(std::move(a), b);
    if (!IsComparison(op)) return WrongType(op);
    return TemplateValue(Compare(op, ToText(a), ToText(b)));
  }
  const auto* truth_a = std::get_if<bool>(&a);
  const auto* truth_b = std::get_if<bool>(&b);
  if (truth_a != nullptr && truth_b != nullptr && (op == "==" || op == "!=" || op == "<>")) {
    return TemplateValue(Compare(op, *truth_a, *truth_b));
  }
  const auto number_a = Number(a);
  const auto number_b = Number(b);
  if (!number_a || !number_b) return WrongType(op);
  const auto* whole_a = std::get_if<int64_t>(&a);
  const auto* whole_b = std::get_if<int64_t>(&b);
  const bool whole = whole_a != nullptr && whole_b != nullptr;
  if (IsComparison(op)) {
    return TemplateValue(whole ? Compare(op, *whole_a, *whole_b)
                               : Compare(op, *number_a, *number_b));
  }
  return whole ? ApplyWhole(op, *whole_a, *whole_b) : ApplyReal(op, *number_a, *number_b);
}

absl::StatusOr<TemplateValue> Negated(const TemplateValue& value) {
  return Apply("-", TemplateValue(int64_t{0}), value);
}

absl::StatusOr<TemplateValue> Call(std::string_view function,
                                   std::span<const TemplateValue> arguments,
                                   std::span<const bool> patterns) {
  if (function == "min" || function == "max")
    return Extreme(arguments[0], arguments[1], function == "min");
  if (function == "int" || function == "round") return ToWhole(arguments[0], function);
  if (function == "interpolate_table") return Interpolated(arguments);
  if (function == "one_of") return IsOneOf(arguments, patterns);
  return Digits(arguments, function == "zdigits");
}

absl::StatusOr<TemplateValue> Random(const TemplateValue& from, const TemplateValue& to,
                                     std::mt19937& random) {
  const auto x = Number(from);
  const auto y = Number(to);
  if (!x || !y) return WrongType("random");
  constexpr double kRange = 4294967296.0;  // number of values of the generator
  const double share = static_cast<double>(random()) / kRange;
  const bool whole = std::holds_alternative<int64_t>(from) && std::holds_alternative<int64_t>(to);
  if (!whole) return TemplateValue(*x + (*y - *x) * share);
  if (!(*x <= *y) || std::abs(*x) > kMostWhole || std::abs(*y) > kMostWhole)
    return absl::InvalidArgumentError("random: the range is empty");
  return TemplateValue(static_cast<int64_t>(*x + std::floor((*y - *x + 1) * share)));
}

absl::StatusOr<bool> Truth(const TemplateValue& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth;
  if (const auto* whole = std::get_if<int64_t>(&value)) return *whole != 0;
  if (const auto* number = std::get_if<double>(&value)) return *number != 0;
  return absl::InvalidArgumentError("a condition must be true or false, not text");
}

}  // namespace slicefarm::macro
