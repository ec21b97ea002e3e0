#pragma once

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Solid area, divided by the length of its lines.
struct SolidParts {
  MultiPolygon wide;
  MultiPolygon narrow;
};

/// Divides a solid area into the parts in which three or more lines side by side are shorter than
/// `least_nm`, or in which all lines are, and the rest. `lines`: lines that would fill the area.
/// Narrow parts that have no space for a line belong to the wide part. Errors: see CutLines. Cost:
/// the cost of CutLines, and two offsets and three boolean operations if there are short lines.
absl::StatusOr<SolidParts> PartByLines(const MultiPolygon& solid, const LineFamily& lines,
                                       double least_nm);

/// Divides a solid area into the part that is at least `narrow_nm` wide and the rest. Narrow parts
/// that have no space for a line of `width_nm` belong to the wide part. Cost: four offsets and
/// three boolean operations.
SolidParts PartByWidth(const MultiPolygon& solid, Coord narrow_nm, Coord width_nm);

}  // namespace slicefarm::infill
