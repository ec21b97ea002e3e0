#pragma once

#include <optional>
#include <span>

#include "common/model/layers/fill_stats.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Returns the plastic of the beads of a path in a layer of height `height_nm`, in mm3.
double PlasticMm3(const Path& path, Coord height_nm);

/// Plastic that was requested for a fill with paths of one kind.
struct RequestedFill {
  Feature feature = Feature::kInternalInfill;
  std::optional<FillPattern> pattern;  ///< none: lines without a pattern
  double area_nm2 = 0;
  /// Height of the space that the plastic has to fill: of one layer, or of several layers.
  Coord height_nm = 0;
  double share = 1;  ///< requested plastic as a share of this space
};

/// Returns the plastic, length and number of `paths` in a layer of height `layer_height_nm`,
/// together with the request. Cost: O(points).
FillStats UseOf(const RequestedFill& asked, std::span<const Path> paths, Coord layer_height_nm);

}  // namespace slicefarm::infill
