#include "common/gcode/gcode_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace slicefarm {
namespace {

constexpr size_t kLongestInteger = 20;
/// Length of the greatest double with some decimals.
constexpr size_t kLongestFixed = 330;
/// Limit of Real. With five decimals, it is far from the least integer, which has no negative.
constexpr double kMostReal = 9e12;

}  // namespace

GcodeText& GcodeText::Lines(std::string_view code) {
  *this << code;
  return EndsLine() ? *this : *this << '\n';
}

GcodeText& GcodeText::Integer(int64_t value) {
  char buffer[kLongestInteger];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  text_.append(buffer, end);
  return *this;
}

GcodeText& GcodeText::Short(int64_t value, int digits) {
  char buffer[kLongestDecimal];
  text_.append(buffer, WriteDecimal(buffer, value, digits, /*leading_zero=*/false));
  return *this;
}

GcodeText& GcodeText::Decimal(int64_t value, int digits) {
  AppendDecimal(text_, value, digits);
  return *this;
}

GcodeText& GcodeText::Fixed(double value, int digits) {
  char buffer[kLongestFixed];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits).ptr;
  text_.append(buffer, end);
  return *this;
}

GcodeText& GcodeText::Real(double value, int digits) {
  // NaN fails both comparisons of clamp, so it needs a separate check.
  const double bounded = std::isnan(value) ? 0 : std::clamp(value, -kMostReal, kMostReal);
  return Decimal(std::llround(bounded * static_cast<double>(kPowersOfTen[digits])), digits);
}

}  // namespace slicefarm
