#pragma once

#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "common/geometry/box_index.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/region_context.h"
#include "services/infill/algo/skins/sparse_bridges.h"

namespace slicefarm::infill {

// Lines of bridges. A direction of the options replaces the best direction of each bridge, or is
// added to it (relative_bridge_angle). Errors of all functions: see FillSolid.

/// Adds the lines of each bridge over air. Regions that lines cannot span get lines along the
/// supported boundary (FillOverhang) if the options request this.
absl::Status AppendBridges(const RegionContext& context, const MultiPolygon& regions, Fills& fills);

/// Bridges over air of a layer, with the direction of each one's lines.
class SpannedBridges {
 public:
  /// Returns the bridges of the layer below a context's layer. They are computed again, from the
  /// outline of that layer without walls: an area above them may be too small to reach the bearers
  /// of its bridge. Cost: that of PartFillArea for the layer.
  static SpannedBridges Below(const RegionContext& context);

  /// Returns the direction of the bridge that bears most of a region in the layer above; nothing if
  /// none does, or if its lines have the default direction.
  std::optional<double> AngleUnder(const PolygonWithHoles& region) const;

 private:
  /// `context`: context of the bridges' own layer.
  SpannedBridges(const RegionContext& context, MultiPolygon regions);

  MultiPolygon regions_;
  BoxIndex index_;
  std::vector<std::optional<double>> angles_;  ///< indexed like `regions_`
};

/// Adds second layers of bridges over air, parallel to the bridges in the layer below (`bearing`).
absl::Status AppendSecondBridges(const RegionContext& context, const MultiPolygon& regions,
                                 const SpannedBridges& bearing, Fills& fills);

/// Adds bridges between lines of sparse infill.
absl::Status AppendSparseBridges(const RegionContext& context, const SparseBridges& bridges,
                                 Fills& fills);

/// Adds second layers of bridges over sparse infill, across the bridges in the layer below.
absl::Status AppendSecondSparseBridges(const RegionContext& context, const SparseBridges& bridges,
                                       Fills& fills);

}  // namespace slicefarm::infill
