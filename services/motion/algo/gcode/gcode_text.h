#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace slicefarm::motion {

/// Units in which positions and filament stand in the text: what is planned is what is printed, to
/// the last digit.
inline constexpr int64_t kUmPerMm = 1'000;
inline constexpr int64_t kFilamentUnitsPerMm = 100'000;

/// Text that grows, with numbers as G-code likes them: exact decimals without trailing zeros and
/// without a zero before the point ("-.05", "12.3", "0").
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
  GcodeText& Micrometers(int64_t um) { return Decimal(um, 3); }
  GcodeText& Filament(int64_t units) { return Decimal(units, 5); }
  /// Rounded to `digits` decimals ("0.2"); what lies beyond 9e12 as that, not a number as 0.
  /// REQUIRES: digits <= 5.
  GcodeText& Real(double value, int digits);

  const std::string& text() const { return text_; }
  std::string Take() { return std::move(text_); }

 private:
  bool EndsLine() const { return text_.empty() || text_.back() == '\n'; }
  /// value / 10^digits. REQUIRES: value > INT64_MIN.
  GcodeText& Decimal(int64_t value, int digits, bool leading_zero = false);

  std::string text_;
};

}  // namespace slicefarm::motion
