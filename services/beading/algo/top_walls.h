#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"
#include "services/beading/algo/classic/constant_walls.h"

namespace slicefarm::beading {

/// Division of the area inside an island's outermost wall.
struct TopParts {
  MultiPolygon top;      ///< parts visible from above: they get top infill and no inner walls
  MultiPolygon covered;  ///< remaining parts, which get inner walls along their boundary
};

/// Divides `inside` into the parts that `above`, the outlines of the layer above, covers or leaves
/// visible. Areas over air count as covered, because inner walls have to support their infill. The
/// wall beside a top surface is under the outermost wall of the layer above, which hides it. Top
/// surfaces narrower than half an inner wall, or than WallPlan::min_top_nm, also count as covered.
/// `below`: outlines of the layer below; null: the bed.
///
/// Cost: O(n log n), n points; only one difference if nothing is visible from above.
TopParts PartByTop(const MultiPolygon& inside, const MultiPolygon& above, const MultiPolygon* below,
                   const WallPlan& plan);

/// Makes walls inner walls: adds 1 to each inset and sets Feature::kPerimeter. For walls that were
/// made as outermost walls inside the real outermost wall. Gap fill does not change.
void MakeInner(std::vector<Path>& walls);

}  // namespace slicefarm::beading
