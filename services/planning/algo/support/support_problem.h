#pragma once

#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// A layer of something that stands on the plate: it fills `outlines` from top_nm - height_nm to
/// top_nm, nm above the bed.
struct SolidLayer {
  Coord top_nm = 0;
  Coord height_nm = 0;
  const MultiPolygon* outlines = nullptr;  ///< not owned, never null

  Coord bottom_nm() const { return top_nm - height_nm; }
};

/// A layer of the part, with what is said of its underside.
struct PartLayer : SolidLayer {
  const MultiPolygon* enforcers = nullptr;  ///< null: none
  const MultiPolygon* blockers = nullptr;   ///< null: none
};

/// What is to be supported, in the coordinates of one object. What stands around its copies is all
/// put around it, so that one support serves them all.
struct SupportProblem {
  std::vector<PartLayer> part;  ///< upwards, without gaps between them
  /// Other objects, each upwards: supports keep off them and do not stand on them.
  std::vector<std::vector<SolidLayer>> others;
  MultiPolygon bed;  ///< supports stay on it; empty: no bounds
  /// How far the first layer of branches reaches beyond what stands on it.
  Coord first_layer_expansion_nm = 0;
};

}  // namespace slicefarm::planning
