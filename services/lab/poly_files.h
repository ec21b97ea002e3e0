#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::lab {

/// Polygons of a file, with the file's numbers unchanged: coordinates are in 10^-decimals of the
/// file's unit.
struct PolyFile {
  MultiPolygon islands;
  int decimals = 0;
};

/// Reads polygons in one of three formats, which is detected from the text:
///   .poly     number of chains; of each its number of points, `out` or `in` (a hole), the points,
///             and their order as indices from 1;
///   outlines  as ParseOutlines: two heights, then rings with their numbers of points, nested;
///   points    `x y` per line, one ring.
/// `#` starts a comment. Rings may have either direction. The position of a hole determines its
/// island. Numbers with too many digits are rounded.
///
/// Errors: kRequestMalformed, with the unreadable part.
absl::StatusOr<PolyFile> ParsePoly(std::string_view text);

/// Returns `value` / 10^decimals in full, without trailing zeros.
std::string DecimalText(Coord value, int decimals);

}  // namespace slicefarm::lab
