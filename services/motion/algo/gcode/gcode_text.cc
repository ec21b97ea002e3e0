#include "services/motion/algo/gcode/gcode_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace slicefarm::motion {
namespace {

constexpr int64_t kPowers[] = {1, 10, 100, 1'000, 10'000, 100'000};
constexpr size_t kLongestInteger = 20;
/// With five decimals, far from the least whole number, which has no opposite.
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

GcodeText& GcodeText::Decimal(int64_t value, int digits, bool leading_zero) {
  char buffer[kLongestInteger + 2];
  char* at = buffer;
  if (value < 0) {
    *at++ = '-';
    value = -value;
  }
  const int64_t whole = value / kPowers[digits];
  int64_t rest = value % kPowers[digits];
  if (leading_zero || whole != 0 || rest == 0)
    at = std::to_chars(at, buffer + sizeof buffer, whole).ptr;
  if (rest != 0) {
    *at++ = '.';
    for (int i = digits - 1; rest != 0; --i) {
      *at++ = static_cast<char>('0' + rest / kPowers[i]);
      rest %= kPowers[i];
    }
  }
  text_.append(buffer, at);
  return *this;
}

GcodeText& GcodeText::Real(double value, int digits) {
  // Not a number fails both comparisons of clamp and would come through.
  const double bounded = std::isnan(value) ? 0 : std::clamp(value, -kMostReal, kMostReal);
  return Decimal(std::llround(bounded * static_cast<double>(kPowers[digits])), digits,
                 /*leading_zero=*/true);
}

}  // namespace slicefarm::motion
