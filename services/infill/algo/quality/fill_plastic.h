#pragma once

#include <optional>
#include <span>

#include "common/model/layers/fill_stats.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Returns the plastic of the beads of a path in a layer of height `height_nm`, in mm3.
double PlasticMm3(const Path& path, Coord height_nm);

/// Plastic that was requested for one fill of an area.
struct RequestedFill {
  Feature feature = Feature::kInternalInfill;
  /// pattern of the fill; nullopt for lines without a pattern, such as bridges
  std::optional<FillPattern> pattern;
  double area_nm2 = 0;
  /// Height that the plastic has to fill: the height of one layer, or of several combined layers.
  Coord height_nm = 0;
  double share = 1;  ///< requested plastic as a share of area * height
};

/// Returns the plastic, length and number of `paths` in a layer of height `layer_height_nm`,
/// together with the requested plastic. Cost: O(points).
FillStats UseOf(const RequestedFill& asked, std::span<const Path> paths, Coord layer_height_nm);

}  // namespace slicefarm::infill
