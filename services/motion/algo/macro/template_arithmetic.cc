#include "services/motion/algo/macro/template_arithmetic.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "absl/strings/str_format.h"
#include "common/model/limits.h"
#include "services/motion/algo/macro/text_pattern.h"

namespace slicefarm::motion {
namespace {

constexpr int64_t kMostDigits = 64;

absl::Status WrongType(std::string_view op) {
  return absl::InvalidArgumentError("operands of the wrong type for \"" + std::string(op) + "\"");
}

std::optional<double> Number(const TemplateValue& value) {
  if (const auto* whole = std::get_if<int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return {};
}

template <typename T>
bool Compare(std::string_view op, const T& a, const T& b) {
  if (op == "==") return a == b;
  if (op == "!=" || op == "<>") return a != b;
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
  if (!(std::abs(*number) < 1e18)) return absl::InvalidArgumentError("number too large");
  return TemplateValue(static_cast<int64_t>(function == "round" ? std::round(*number) : *number));
}

/// digits(5, 3) is "  5", zdigits(5, 3) "005", digits(1.25, 5, 1) "  1.3".
absl::StatusOr<TemplateValue> Digits(const std::vector<TemplateValue>& arguments, bool zeros) {
  const auto value = Number(arguments[0]);
  const auto* width = std::get_if<int64_t>(&arguments[1]);
  const int64_t zero = 0;
  const auto* decimals = arguments.size() > 2 ? std::get_if<int64_t>(&arguments[2]) : &zero;
  if (!value || width == nullptr || decimals == nullptr) return WrongType("digits");
  if (*width < 0 || *width > kMostDigits || *decimals < 0 || *decimals > kMostDigits ||
      !(std::abs(*value) < 1e18)) {
    return absl::InvalidArgumentError("digits out of range");
  }
  const int w = static_cast<int>(*width);
  const int d = static_cast<int>(*decimals);
  return TemplateValue(zeros ? absl::StrFormat("%0*.*f", w, d, *value)
                             : absl::StrFormat("%*.*f", w, d, *value));
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
                                   const std::vector<TemplateValue>& arguments) {
  const size_t count = arguments.size();
  if ((function == "min" || function == "max") && count == 2) {
    const auto less = Apply("<", arguments[0], arguments[1]);
    if (!less.ok()) return less.status();
    return std::get<bool>(*less) == (function == "min") ? arguments[0] : arguments[1];
  }
  if ((function == "int" || function == "round") && count == 1) {
    return ToWhole(arguments[0], function);
  }
  if ((function == "digits" || function == "zdigits") && (count == 2 || count == 3)) {
    return Digits(arguments, function == "zdigits");
  }
  return absl::InvalidArgumentError("unknown function \"" + std::string(function) + "\" of " +
                                    std::to_string(count) + " arguments");
}

}  // namespace slicefarm::motion
