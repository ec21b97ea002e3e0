#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"
#include "services/beading/algo/classic/constant_walls.h"

namespace slicefarm::beading {

/// Areas inside of an island's outermost wall.
struct TopParts {
  MultiPolygon top;      ///< part visible from above: it gets top infill, and no inner walls
  MultiPolygon covered;  ///< other part, with inner walls around it
};

/// Divides `inside` into the parts that `above`, the outlines of the layer above, covers or leaves
/// visible. Areas over air count as covered, because inner walls have to support their infill. The
/// wall beside a top surface is under the outermost wall of the layer above, which hides it. Top
/// surfaces narrower than half an inner wall also count as covered. `below`: outlines of the layer
/// below; null: the bed.
///
/// Cost: O(n log n), n points; only one difference if nothing is visible from above.
TopParts PartByTop(const MultiPolygon& inside, const MultiPolygon& above, const MultiPolygon* below,
                   const WallPlan& plan);

/// Increases the inset of each wall by one and makes it an inner wall, for walls that were made
/// inside an outermost wall.
void MakeInner(std::vector<Path>& walls);

}  // namespace slicefarm::beading
