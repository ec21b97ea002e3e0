#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"
#include "services/beading/algo/classic/constant_walls.h"


namespace slicefarm::beading {

/// Areas inside of an island's outermost wall.
struct TopParts {
  MultiPolygon top;      ///< visible from above: for the top infill, without inner walls
  MultiPolygon covered;  ///< the rest, with inner walls around it
};

/// Divides `inside` by the coverage of the layer above. Areas over air stay covered, because their
/// inner walls support them. The wall beside a top surface is under the outermost wall of the layer
/// above, which hides it. Top surfaces narrower than half an inner wall stay covered. `below` may
/// be null: the bed.
///
/// Cost: O(n log n); only one difference if nothing is visible from above.
TopParts PartByTop(const MultiPolygon& inside, const MultiPolygon& above, const MultiPolygon* below,
                   const WallPlan& plan);

/// Changes walls made inside an outermost wall into inner walls of this wall.
void MakeInner(std::vector<Path>& walls);

}  // namespace slicefarm::beading
