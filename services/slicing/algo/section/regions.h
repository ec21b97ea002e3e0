#pragma once

#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/polygon.h"
#include "common/model/options/slicing_options.h"

namespace slicefarm::slicing {

/// The region that a layer's loops enclose under `rule`, simplified to `resolution_nm`: disjoint
/// islands in canonical form, outer rings counter-clockwise, holes clockwise, every point a true
/// corner.
///
/// Loops are simplified one by one; if they then neither touch nor cross (the sound case) they are
/// only nested, else Union sorts them out. Cost: that of SimplifyRing and NestSimpleLoops, or of a
/// union.
MultiPolygon RegionOf(const std::vector<Polygon>& loops, FillRule rule, Coord resolution_nm);

/// What the outer rings of a region enclose, islands in its holes included. Cost: O(n) where it has
/// no holes.
MultiPolygon WithoutHoles(const MultiPolygon& region);

/// What is done to a region after it was found, in this order.
struct RegionEdits {
  Coord closing_radius_nm = 0;  ///< cracks up to twice this wide are closed
  Coord grow_nm = 0;            ///< all outlines move outwards, into holes too; may be negative
  Coord foot_nm = 0;            ///< then shrinks by this, but where that leaves less than:
  Coord foot_min_width_nm = 0;
  Coord widen_holes_nm = 0;  ///< holes grow; may be negative

  friend bool operator==(const RegionEdits&, const RegionEdits&) = default;
};

/// The edits for layer `layer` of a mesh that is closed or not: xy_size_compensation grows;
/// elefant_foot_compensation shrinks the first layer of what stands on the bed, see ElephantFootCompensated (one below 0
/// grows it evenly); xy_hole_compensation widens holes; slice_closing_radius works on meshes that
/// are not closed manifolds only.
RegionEdits EditsFor(int32_t layer, bool closed_mesh, const ObjectSlicingOptions& options);

/// Offsets have mitred corners. Free of cost if there is nothing to edit.
MultiPolygon Edited(MultiPolygon region, const RegionEdits& edits, Coord resolution_nm);

}  // namespace slicefarm::slicing
