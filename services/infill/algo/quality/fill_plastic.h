#pragma once

#include <optional>
#include <span>

#include "common/model/layers/fill_use.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Returns the plastic of a bead of height `height_nm`, in mm3.
double PlasticMm3(const Path& path, Coord height_nm);

/// Request for a fill with paths of one kind.
struct AskedFill {
  Feature feature = Feature::kInternalInfill;
  std::optional<FillPattern> pattern;  ///< none: lines without a pattern
  double area_nm2 = 0;
  /// Height of the space that the plastic is for: one layer, or several layers.
  Coord height_nm = 0;
  double share = 1;     ///< requested plastic as a share of this space
};

/// Returns the plastic, length and number of `paths` of height `layer_height_nm`. Cost: O(points).
FillUse UseOf(const AskedFill& asked, std::span<const Path> paths, Coord layer_height_nm);

}  // namespace slicefarm::infill
