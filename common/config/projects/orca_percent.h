#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/base/text.h"
#include "common/config/table/value.h"

namespace slicefarm::config {

/// Returns a number as a percentage of `whole`; a percentage is returned unchanged. Returns nullopt
/// if the text is not a number, or if `whole` is missing or not positive.
inline std::optional<std::string> ShareOf(std::string_view text, std::optional<double> whole) {
  if (text.ends_with('%')) return std::string(text);
  const std::optional<double> number = ToNumber(Trim(text));
  if (!number || (*number != 0 && whole.value_or(0) <= 0)) return std::nullopt;
  return PrintNumber(*number == 0 ? 0 : Quantise(100 * *number / *whole)) + "%";
}

/// Returns the complement of a percentage to 100 %: "0.5%" for "99.5%" or "99.5". Returns nullopt
/// if the text is not a number.
inline std::optional<std::string> RestOf(std::string_view text) {
  if (text.ends_with('%')) text.remove_suffix(1);
  const std::optional<double> percent = ToNumber(Trim(text));
  if (!percent) return std::nullopt;
  return PrintNumber(Quantise(100 - *percent)) + "%";
}

}  // namespace slicefarm::config
