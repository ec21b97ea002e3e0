#pragma once

#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/geometry/point.h"
#include "common/model/limits.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

/// Length in nm, and the name of the member with this length, for error messages.
struct NamedLength {
  std::string_view member;
  Coord value_nm = 0;
};

/// Checks that each length is in [least_nm, limits::kMaxCoord]. Errors: REQUEST_MALFORMED with the
/// name of the first length outside of this range.
inline absl::Status CheckLengths(std::initializer_list<NamedLength> lengths, Coord least_nm) {
  for (const auto& [member, value_nm] : lengths)
    if (value_nm < least_nm || value_nm > limits::kMaxCoord)
      return Malformed(member, "is out of range");
  return absl::OkStatus();
}

/// Checks that all lengths are positive.
inline absl::Status CheckPositive(std::initializer_list<NamedLength> lengths) {
  return CheckLengths(lengths, 1);
}

/// Checks that no length is negative.
inline absl::Status CheckNotNegative(std::initializer_list<NamedLength> lengths) {
  return CheckLengths(lengths, 0);
}

/// Checks that least <= value <= most. Errors: REQUEST_MALFORMED.
inline absl::Status CheckRange(std::string_view member, double value, double least, double most) {
  return least <= value && value <= most ? absl::OkStatus() : Malformed(member, "is out of range");
}

/// Checks that the value is above 0. Errors: REQUEST_MALFORMED.
inline absl::Status CheckAboveZero(std::string_view member, double value) {
  return value > 0 ? absl::OkStatus() : Malformed(member, "is not above 0");
}

/// Checks that the value is 0 or more. Errors: REQUEST_MALFORMED.
inline absl::Status CheckNoLessThanZero(std::string_view member, double value) {
  return value >= 0 ? absl::OkStatus() : Malformed(member, "is negative");
}

/// Checks that a table has at least one row and at most limits::kMaxRegionSettings rows.
absl::Status CheckRows(size_t rows, std::string_view table);

/// Calls `check` for each row of a table. Returns the first error, with the path to the row.
template <typename Row, typename Check>
absl::Status CheckEach(const std::vector<Row>& table, std::string_view name, const Check& check) {
  absl::Status status = CheckRows(table.size(), name);
  for (size_t row = 0; row < table.size() && status.ok(); ++row)
    if (const absl::Status of_row = check(table[row]); !of_row.ok())
      status = Within(name, row, of_row);
  return status;
}

}  // namespace slicefarm
