#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::lab {

/// A polygon file's numbers as they are written: coordinates are in 10^-decimals of its unit.
struct PolyFile {
  MultiPolygon islands;
  int decimals = 0;
};

/// Reads, by what the text looks like:
///   .poly     number of chains; of each its number of points, `out` or `in` (a hole), the points,
///             and their order as indices from 1;
///   outlines  as ParseOutlines: two heights, then rings with their numbers of points, nested;
///   points    `x y` a line, one ring.
/// `#` starts a comment. Rings may turn either way; which hole belongs to which island is found by
/// where it lies. Numbers with more digits than fit are rounded.
///
/// Errors: kRequestMalformed, with what could not be read.
absl::StatusOr<PolyFile> ParsePoly(std::string_view text);

/// `value` / 10^decimals in full, without trailing zeros.
std::string DecimalText(Coord value, int decimals);

}  // namespace slicefarm::lab
