#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::lab {

/// Polygons of a file. Coordinates are integers in units of 10^-decimals of the file's unit, so
/// that they have the file's values exactly.
struct PolyFile {
  MultiPolygon islands;
  int decimals = 0;
};

/// Reads polygons in one of three formats, which is detected from the text:
///   .poly     number of chains; for each chain its number of points, `out` or `in` (a hole), the
///             points, and their order as indices from 1;
///   outlines  as ParseOutlines: two unused numbers, then rings with their numbers of points;
///   points    `x y` per line, one ring.
/// `#` starts a comment. Rings may have either direction. A hole belongs to the island that
/// contains it. Numbers with too many digits are rounded.
///
/// Errors: kRequestMalformed, with the text that cannot be read.
absl::StatusOr<PolyFile> ParsePoly(std::string_view text);

/// Returns `value` / 10^decimals as an exact decimal number without trailing zeros.
std::string DecimalText(Coord value, int decimals);

}  // namespace slicefarm::lab
