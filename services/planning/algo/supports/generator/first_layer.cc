#include "services/planning/algo/supports/generator/first_layer.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::planning {
namespace {

bool IsInterface(const SupportRegion& region) {
  return region.role == SupportRole::kTopInterface || region.role == SupportRole::kBottomInterface;
}

MultiPolygon All(const SupportLayer& layer) {
  std::vector<Polygon> rings;
  for (const SupportRegion& region : layer.regions)
    for (Polygon& ring : Rings(region.outlines)) rings.push_back(std::move(ring));
  return Union(rings, FillRule::kNonZero);
}

}  // namespace

void GrowFirstLayer(Coord by_nm, Coord width_nm, const Clearance& clearance, SupportLayer& layer) {
  if (by_nm <= 0 || layer.regions.empty()) return;
  MultiPolygon grown = All(layer);
  const Coord steps = (by_nm + width_nm - 1) / width_nm;
  for (Coord i = 0; i < steps; ++i)
    grown = clearance.Free(FastOffset(grown, by_nm * (i + 1) / steps - by_nm * i / steps),
                           layer.top_nm - layer.height_nm, layer.top_nm);
  std::vector<Polygon> interfaces;
  for (const SupportRegion& region : layer.regions)
    if (IsInterface(region))
      for (Polygon& ring : Rings(region.outlines)) interfaces.push_back(std::move(ring));
  std::erase_if(layer.regions, [](const SupportRegion& region) { return !IsInterface(region); });
  if (!interfaces.empty()) grown = WithoutRings(grown, interfaces);
  if (!grown.empty())
    layer.regions.insert(layer.regions.begin(), {SupportRole::kBranch, std::move(grown)});
}

}  // namespace slicefarm::planning
