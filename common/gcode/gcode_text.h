#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/decimal_text.h"

namespace slicefarm {

/// Units in which positions and filament stand in the text: what is planned is what is printed, to
/// the last digit.
inline constexpr int64_t kUmPerMm = 1'000;
inline constexpr int64_t kFilamentUnitsPerMm = 100'000;

/// Text that grows, with numbers as G-code likes them: exact decimals without zeros at their end,
/// those that stand in each line without a zero before the point ("-.05", "12.3", "0") either. What
/// all processes write their G-code with.
class GcodeText {
 public:
  explicit GcodeText(size_t expected_bytes = 0) { text_.reserve(expected_bytes); }

  GcodeText& operator<<(std::string_view part) {
    text_.append(part);
    return *this;
  }
  GcodeText& operator<<(char part) {
    text_.push_back(part);
    return *this;
  }
  /// A piece of G-code, whose last line is ended.
  GcodeText& Lines(std::string_view code);
  GcodeText& Integer(int64_t value);
  GcodeText& Micrometers(int64_t um) { return Short(um, 3); }
  GcodeText& Filament(int64_t units) { return Short(units, 5); }
  /// value / 10^digits, with a zero before the point. REQUIRES: digits <= 6, value > INT64_MIN.
  GcodeText& Decimal(int64_t value, int digits);
  /// nm as mm, rounded to so many digits, with a zero before the point. REQUIRES: digits <= 6.
  GcodeText& Mm(int64_t nm, int digits) { return Decimal(RoundedNm(nm, digits), digits); }
  /// With all of its digits: "1.000".
  GcodeText& Fixed(double value, int digits);
  /// Rounded to `digits` decimals ("0.2"); what lies beyond 9e12 as that, not a number as 0.
  /// REQUIRES: digits <= 5.
  GcodeText& Real(double value, int digits);

  const std::string& text() const { return text_; }
  std::string Take() { return std::move(text_); }

 private:
  bool EndsLine() const { return text_.empty() || text_.back() == '\n'; }
  GcodeText& Short(int64_t value, int digits);

  std::string text_;
};

}  // namespace slicefarm
