#pragma once

#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Layer of an object on the plate. The solid fills `outlines` from the height top_nm - height_nm
/// up to top_nm, in nm above the bed.
struct SolidLayer {
  Coord top_nm = 0;
  Coord height_nm = 0;
  const MultiPolygon* outlines = nullptr;  ///< not owned, never null

  Coord bottom_nm() const { return top_nm - height_nm; }
};

/// Layer of the part, with the marked areas of its underside.
struct PartLayer : SolidLayer {
  const MultiPolygon* enforcers = nullptr;  ///< areas where the user enforces supports; null: none
  const MultiPolygon* blockers = nullptr;   ///< areas where the user blocks supports; null: none
};

/// Input for the supports of one object, in the object's own coordinates. All copies of the object
/// get the same supports. So `others` contains the neighbouring objects of each copy, moved with
/// this copy into the object's coordinates. One neighbour may occur several times.
struct SupportProblem {
  std::vector<PartLayer> part;  ///< layers bottom up, without gaps between them
  /// Other objects, each as layers from the lowest up. Supports keep away from them and are never
  /// printed on them.
  std::vector<std::vector<SolidLayer>> others;
  MultiPolygon bed;  ///< bed that supports do not leave; empty: no limit
  /// Distance by which the first layer of branches is widened, in nm.
  Coord first_layer_expansion_nm = 0;
};

}  // namespace slicefarm::planning
