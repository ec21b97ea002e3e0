#include "services/infill/algo/locked_zag.h"

#include <numbers>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::infill {

std::vector<SparseZone> LockedZones(const MultiPolygon& region, const SparseFill& fill,
                                    const LockedZagOptions& options) {
  const MultiPolygon inside = FastOffset(region, -options.skin_depth_nm);
  SparseZone skin{inside.empty() ? region : Difference(region, inside), fill};
  skin.fill.pattern = FillPattern::kCrossZag;
  skin.fill.density = options.skin_density;
  skin.fill.width_nm = options.skin_width_nm;
  std::vector<SparseZone> zones = {std::move(skin)};
  if (inside.empty()) return zones;
  SparseZone skeleton{Intersection(FastOffset(inside, options.lock_depth_nm), region), fill};
  skeleton.fill.pattern = FillPattern::kZigzag;
  skeleton.fill.density = options.skeleton_density;
  skeleton.fill.width_nm = options.skeleton_width_nm;
  skeleton.fill.angle_rad += std::numbers::pi / 2;
  zones.push_back(std::move(skeleton));
  return zones;
}

}  // namespace slicefarm::infill
