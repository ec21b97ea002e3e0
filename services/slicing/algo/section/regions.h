#pragma once

#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/polygon.h"
#include "common/model/options/slicing_options.h"

namespace slicefarm::slicing {

/// Returns the region that a layer's loops enclose under `rule`, simplified to `resolution_nm`. The
/// result has disjoint islands in canonical form, with counter-clockwise outer rings, clockwise
/// holes, and only true corners as points.
///
/// Loops are simplified one by one. If the simplified loops neither touch nor cross (the normal
/// case), NestSimpleLoops assigns holes to islands; otherwise Union separates the loops. Cost:
/// SimplifyRing of each loop, and NestSimpleLoops or Union.
MultiPolygon RegionOf(const std::vector<Polygon>& loops, FillRule rule, Coord resolution_nm);

/// Changes of a region, in the order of application.
struct RegionEdits {
  Coord closing_radius_nm = 0;  ///< cracks up to twice this wide are closed
  /// Distance by which all outlines move outwards, also into holes; may be negative.
  Coord grow_nm = 0;
  /// distance by which the region then shrinks (elephant foot); thin sections shrink less
  Coord foot_nm = 0;
  Coord foot_min_width_nm = 0;
  /// distance by which the outlines of holes move outwards; may be negative
  Coord widen_holes_nm = 0;

  friend bool operator==(const RegionEdits&, const RegionEdits&) = default;
};

/// Returns the edits for layer `layer` of an object.
///
/// - xy_size_compensation grows the region.
/// - elefant_foot_compensation shrinks the first layer of objects on the bed, see
///   ElephantFootCompensated. A negative value grows it evenly.
/// - xy_hole_compensation widens holes.
/// - slice_closing_radius applies only to meshes that are not closed manifolds.
RegionEdits EditsFor(int32_t layer, bool closed_mesh, const ObjectSlicingOptions& options);

/// Applies the edits. Offsets have mitred corners. Without edits the region is returned at no cost.
MultiPolygon Edited(MultiPolygon region, const RegionEdits& edits, Coord resolution_nm);

}  // namespace slicefarm::slicing
