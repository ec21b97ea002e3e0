#pragma once

#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/model/options/slicing_options.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// Returns the middle of the bed's bounding box; the origin for a bed without points.
Point BedCenter(const Polygon& bed);

/// Footprint and height of an object, for the check against the build volume.
struct Bulk {
  const Polygon& footprint;      ///< convex hull seen from above
  Coord top_nm = 0;              ///< height of the object's top above the bed
  Coord xy_compensation_nm = 0;  ///< distance by which slicing moves the object's outlines outwards
};

/// Returns true if a convex footprint, moved by `shift` and grown by `grow_nm`, overlaps one of the
/// excluded areas. Cost: a boolean operation for each area with a box that meets the footprint's
/// box.
bool MeetsExcluded(const Polygon& footprint, Point shift, Coord grow_nm,
                   const std::vector<Polygon>& excluded);

/// Checks that the object, grown and moved to each of `centers`, is within the bed, outside the
/// bed's excluded areas, below max_print_height and within 32-bit nanometres. A bed with fewer than
/// three points is unlimited.
///
/// An object fits if all corners of its convex hull are in the bed or on its boundary, and the hull
/// does not overlap an excluded area. This is exact for convex beds, which all printers have.
///
/// Errors: OUT_OF_BUILD_VOLUME with `object` (the object's name), `excess_mm` (distance beyond the
/// bed; not for excluded areas), `limit` and `got` (sizes in mm); OUT_OF_RANGE. Cost: O(corners)
/// per centre, plus the cost of MeetsExcluded.
absl::Status CheckBuildVolume(const Bulk& bulk, std::string_view name,
                              const std::vector<Point>& centers, const SlicingOptions& options);

}  // namespace slicefarm::slicing
