#include "services/beading/algo/top_walls.h"

#include <algorithm>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm::beading {

TopParts PartByTop(const MultiPolygon& inside, const MultiPolygon& above, const MultiPolygon* below,
                   const WallPlan& plan) {
  TopParts parts{Difference(inside, above), {}};
  const Coord least = std::max(plan.inner_width_nm / 4, plan.min_top_nm / 2);
  const Coord reach = std::max(plan.external_spacing_nm, plan.inner_width_nm);
  if (!parts.top.empty() && below != nullptr)
    if (const MultiPolygon bridges = Difference(parts.top, *below); !bridges.empty())
      parts.top = Difference(parts.top, FastOffset(bridges, reach));
  // The opening is grown by an inner wall's width, so that narrow ends of a top surface remain part
  // of it.
  const MultiPolygon wide = OffsetTwice(parts.top, -least, least + plan.inner_width_nm);
  parts.top = wide.empty() ? wide : Intersection(parts.top, wide);
  parts.covered = parts.top.empty() ? inside : Difference(inside, parts.top);
  return parts;
}

void MakeInner(std::vector<Path>& walls) {
  for (Path& wall : walls) {
    if (wall.feature == Feature::kGapFill) continue;
    wall.feature = Feature::kPerimeter;
    ++wall.inset;
  }
}

}  // namespace slicefarm::beading
