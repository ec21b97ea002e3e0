#pragma once

#include <charconv>
#include <cstdint>
#include <string>

#include "common/geometry/point.h"

namespace slicefarm::exposure {

/// Appends `value` / 10^decimals without zeros at its end: AppendDecimal(1500, 3) is "1.5".
inline void AppendDecimal(std::string& text, int64_t value, int decimals) {
  int64_t one = 1;
  for (int i = 0; i < decimals; ++i) one *= 10;
  while (decimals > 0 && value % 10 == 0) value /= 10, one /= 10, --decimals;
  if (value < 0) text += '-';
  const int64_t size = value < 0 ? -value : value;
  char digits[24];
  const auto whole = std::to_chars(digits, digits + sizeof digits, size / one);
  text.append(digits, whole.ptr);
  if (decimals == 0) return;
  text += '.';
  const auto part = std::to_chars(digits, digits + sizeof digits, one + size % one);
  text.append(digits + 1, part.ptr);  // without the leading 1
}

/// Appends nm as mm, rounded to 10^-decimals of one, half away from zero. REQUIRES: decimals <= 6.
inline void AppendMm(std::string& text, Coord nm, int decimals) {
  int64_t unit = 1;
  for (int i = decimals; i < 6; ++i) unit *= 10;
  AppendDecimal(text, (nm + (nm < 0 ? -unit / 2 : unit / 2)) / unit, decimals);
}

}  // namespace slicefarm::exposure
