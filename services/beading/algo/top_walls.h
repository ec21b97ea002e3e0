#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"
#include "services/beading/algo/classic/constant_walls.h"


namespace slicefarm::beading {

/// What lies inside of an island's outermost wall.
struct TopParts {
  MultiPolygon top;      ///< seen from above: for the top infill, without inner walls
  MultiPolygon covered;  ///< all else, around which inner walls go
};

/// Parts `inside` by what the layer above covers. Places over air stay covered: their inner walls
/// bear them. The wall beside a top lies under the outermost wall of the layer above, which hides
/// it. Tops narrower than half of an inner wall stay covered. `below` may be null: the bed.
/// Cost: O(n log n), and no more than one difference where nothing is seen from above.
TopParts PartByTop(const MultiPolygon& inside, const MultiPolygon& above, const MultiPolygon* below,
                   const WallPlan& plan);

/// Turns walls that were made of what an outermost wall leaves into its inner walls.
void MakeInner(std::vector<Path>& walls);

}  // namespace slicefarm::beading
