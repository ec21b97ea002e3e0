#pragma once

#include "absl/status/status.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/region_context.h"
#include "services/infill/algo/skins/sparse_bridges.h"

namespace slicefarm::infill {

// Lines of bridges. A direction of the options replaces the best direction of each bridge, or is
// added to it (relative_bridge_angle). Errors of all functions: see FillSolid.

/// Adds the lines of each bridge over air. Regions that lines cannot span get lines along the
/// supported boundary (FillOverhang) if the options request this.
absl::Status AppendBridges(const RegionContext& context, const MultiPolygon& regions, Fills& fills);

/// Adds second layers of bridges over air, parallel to the bridges in the layer below. REQUIRES:
/// the context's cover has the bearers of that layer.
absl::Status AppendSecondBridges(const RegionContext& context, const MultiPolygon& regions,
                                 Fills& fills);

/// Adds bridges between lines of sparse infill.
absl::Status AppendSparseBridges(const RegionContext& context, const SparseBridges& bridges,
                                 Fills& fills);

/// Adds second layers of bridges over sparse infill, across the bridges in the layer below.
absl::Status AppendSecondSparseBridges(const RegionContext& context, const SparseBridges& bridges,
                                       Fills& fills);

}  // namespace slicefarm::infill
