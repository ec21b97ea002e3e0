#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/decimal_text.h"

namespace slicefarm {

/// Units of positions and filament in the text, per mm. Planned values are multiples of these
/// units, so that the text contains them exactly.
inline constexpr int64_t kUmPerMm = 1'000;
inline constexpr int64_t kFilamentUnitsPerMm = 100'000;

/// Text builder of G-code for all processes. Decimals are exact and have no trailing zeros.
/// Coordinates and filament also have no zero before the point ("-.05", "12.3", "0").
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
  /// Appends lines of G-code. A line end is added unless `code` has one at its end.
  GcodeText& Lines(std::string_view code);
  /// Appends an integer.
  GcodeText& Integer(int64_t value);
  /// Appends `um` micrometres as mm, without a zero before the point.
  GcodeText& Micrometers(int64_t um) { return Short(um, 3); }
  /// Appends a filament length as mm, without a zero before the point. `units`: length in 1e-5 mm.
  GcodeText& Filament(int64_t units) { return Short(units, 5); }
  /// Appends value / 10^digits, with a zero before the point. REQUIRES: digits <= 6, value >
  /// INT64_MIN.
  GcodeText& Decimal(int64_t value, int digits);
  /// Appends `nm` nanometres as mm, rounded to `digits` decimals, with a zero before the point.
  /// REQUIRES: digits <= 6.
  GcodeText& Mm(int64_t nm, int digits) { return Decimal(RoundedNm(nm, digits), digits); }
  /// Appends a value with all of its `digits` decimals: "1.000".
  GcodeText& Fixed(double value, int digits);
  /// Appends a value rounded to `digits` decimals ("0.2"). Values beyond 9e12 become 9e12, and NaN
  /// becomes 0. REQUIRES: digits <= 5.
  GcodeText& Real(double value, int digits);

  const std::string& text() const { return text_; }
  std::string Take() { return std::move(text_); }

 private:
  bool EndsLine() const { return text_.empty() || text_.back() == '\n'; }
  GcodeText& Short(int64_t value, int digits);

  std::string text_;
};

}  // namespace slicefarm
