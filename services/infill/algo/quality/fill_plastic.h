#pragma once

#include <optional>
#include <span>

#include "common/model/layers/fill_use.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// The plastic of a bead as high as `height_nm`, mm3.
double PlasticMm3(const Path& path, Coord height_nm);

/// What is to be filled with paths of one kind.
struct AskedFill {
  Feature feature = Feature::kInternalInfill;
  std::optional<FillPattern> pattern;  ///< none: lines that follow no pattern
  double area_nm2 = 0;
  Coord height_nm = 0;  ///< of the room that the paths' plastic is for: of one layer, or of several
  double share = 1;     ///< of that room, how much plastic is to be
};

/// What `paths`, as high as `layer_height_nm`, come to. Cost: O(points).
FillUse UseOf(const AskedFill& asked, std::span<const Path> paths, Coord layer_height_nm);

}  // namespace slicefarm::infill
