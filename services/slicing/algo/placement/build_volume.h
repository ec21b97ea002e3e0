#pragma once

#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/model/options/slicing_options.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// The middle of the bed's box; the origin for a bed without points.
Point BedCenter(const Polygon& bed);

/// The room that an object takes.
struct Bulk {
  const Polygon& footprint;     ///< convex
  Coord top_nm = 0;             ///< above the bed
  Coord xy_compensation_nm = 0;  ///< by which its outlines grow
};

/// Returns true if a convex footprint, moved by `shift` and grown, has area in common with one of
/// the areas. Cost: a boolean operation for each area whose box it meets.
bool MeetsExcluded(const Polygon& footprint, Point shift, Coord grow_nm,
                   const std::vector<Polygon>& excluded);

/// Checks that the object, grown and moved to each of `centers`, stays within the bed, out of its
/// excluded areas, under max_print_height and within 32-bit nanometres. A bed of less than three
/// points is unlimited.
///
/// An object fits if all corners of its convex hull lie in the bed or on its edge, and the hull has
/// no area in common with an excluded one; exact for convex beds, which all printers have. Errors:
/// OUT_OF_BUILD_VOLUME with `object` (the object's name), `excess_mm` (how far it reaches out; not
/// into an excluded area), `limit` and `got` (sizes in mm); OUT_OF_RANGE. Cost: O(corners) a centre,
/// and as MeetsExcluded.
absl::Status CheckBuildVolume(const Bulk& bulk, std::string_view name,
                              const std::vector<Point>& centers, const SlicingOptions& options);

}  // namespace slicefarm::slicing
