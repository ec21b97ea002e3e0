#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Solid area, divided by its width.
struct SolidParts {
  MultiPolygon wide;
  MultiPolygon narrow;
};

/// Divides a solid area into the part that is at least `narrow_nm` wide and the rest. Narrow parts
/// that have no space for a line of `width_nm` belong to the wide part. Cost: four offsets and
/// three boolean operations.
SolidParts PartByWidth(const MultiPolygon& solid, Coord narrow_nm, Coord width_nm);

}  // namespace slicefarm::infill
