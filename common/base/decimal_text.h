#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>

namespace slicefarm {

inline constexpr int64_t kPowersOfTen[] = {1, 10, 100, 1'000, 10'000, 100'000, 1'000'000};
/// Largest number of characters of a decimal number, including sign and point.
inline constexpr size_t kLongestDecimal = 22;

/// Writes value / 10^digits at `at`, without trailing zeros: 1500 with 3 digits is "1.5". Returns
/// the end of the text. `leading_zero`: "0.5" instead of ".5". REQUIRES: digits <= 6, value >
/// INT64_MIN, space for kLongestDecimal characters.
inline char* WriteDecimal(char* at, int64_t value, int digits, bool leading_zero) {
  char* const end = at + kLongestDecimal;
  if (value < 0) {
    *at++ = '-';
    value = -value;
  }
  const int64_t whole = value / kPowersOfTen[digits];
  int64_t rest = value % kPowersOfTen[digits];
  if (leading_zero || whole != 0 || rest == 0) at = std::to_chars(at, end, whole).ptr;
  if (rest == 0) return at;
  *at++ = '.';
  for (int i = digits - 1; rest != 0; --i) {
    *at++ = static_cast<char>('0' + rest / kPowersOfTen[i]);
    rest %= kPowersOfTen[i];
  }
  return at;
}

/// Appends value / 10^digits as WriteDecimal does, with a zero before the point. REQUIRES: digits
/// <= 6, value > INT64_MIN.
inline void AppendDecimal(std::string& text, int64_t value, int digits) {
  char buffer[kLongestDecimal];
  text.append(buffer, WriteDecimal(buffer, value, digits, /*leading_zero=*/true));
}

/// Converts nm to units of 10^-digits mm, rounded half away from zero. REQUIRES: digits <= 6.
inline int64_t RoundedNm(int64_t nm, int digits) {
  const int64_t unit = kPowersOfTen[6 - digits];
  return (nm + (nm < 0 ? -unit / 2 : unit / 2)) / unit;
}

/// Appends a length in mm, rounded to `digits` decimal digits. REQUIRES: digits <= 6.
inline void AppendMm(std::string& text, int64_t nm, int digits) {
  AppendDecimal(text, RoundedNm(nm, digits), digits);
}

}  // namespace slicefarm
