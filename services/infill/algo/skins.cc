#include "services/infill/algo/skins.h"

#include <algorithm>
#include <utility>

#include "common/geometry/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset.h"

namespace slicefarm::infill {
namespace {

/// How far skins reach into the sparse region, in beads.
constexpr Coord kAnchorBeads = 2;
constexpr Coord kRoundingNm = 10;

/// The part of `region` that is at least `width_nm` wide.
MultiPolygon WithoutSlivers(const MultiPolygon& region, Coord width_nm) {
  const MultiPolygon core = Offset(region, -width_nm / 2);
  if (core.empty()) return {};
  return Intersection(region, Offset(core, width_nm / 2 + kRoundingNm));
}

bool HasAir(const std::vector<const MultiPolygon*>& layers) {
  return std::any_of(layers.begin(), layers.end(),
                     [](const MultiPolygon* layer) { return layer == nullptr || layer->empty(); });
}

/// The outlines that decide: those equal to this layer's cover all of it, and equal neighbours say
/// the same.
std::vector<const MultiPolygon*> Deciding(const MultiPolygon& outline, const Cover& cover) {
  std::vector<const MultiPolygon*> deciding;
  for (const auto* side : {&cover.above, &cover.below}) {
    const MultiPolygon* previous = &outline;
    for (const MultiPolygon* layer : *side) {
      if (*layer != *previous && *layer != outline) deciding.push_back(layer);
      previous = layer;
    }
  }
  return deciding;
}

MultiPolygon SmallOnes(const MultiPolygon& regions, double area_mm2) {
  MultiPolygon small;
  for (const PolygonWithHoles& region : regions)
    if (Area(region) < area_mm2 * kNmPerMm * kNmPerMm) small.push_back(region);
  return small;
}

/// The part of `area` that is exposed on a side whose nearest layer is `nearest`.
MultiPolygon Exposed(const MultiPolygon& area, const std::vector<const MultiPolygon*>& side,
                     const MultiPolygon& outline, Coord width_nm) {
  if (side.empty() || area.empty()) return {};
  if (side[0] == nullptr || side[0]->empty()) return area;
  if (*side[0] == outline) return {};
  return WithoutSlivers(Difference(area, *side[0]), width_nm);
}

MultiPolygon SparsePart(const MultiPolygon& fill_area, const MultiPolygon& outline,
                        const Cover& cover, const SkinOptions& options) {
  if (options.all_solid || HasAir(cover.above) || HasAir(cover.below)) return {};
  const std::vector<const MultiPolygon*> deciding = Deciding(outline, cover);
  if (deciding.empty()) return fill_area;
  const MultiPolygon bare =
      DifferenceCovered(fill_area, deciding, static_cast<int>(deciding.size()));
  const MultiPolygon skin = WithoutSlivers(bare, options.width_nm);
  if (skin.empty()) return fill_area;
  const MultiPolygon sparse = Difference(fill_area, Offset(skin, kAnchorBeads * options.width_nm));
  return WithoutSlivers(sparse, 2 * options.width_nm);
}

}  // namespace

Skins PartFillArea(const MultiPolygon& fill_area, const MultiPolygon& outline, const Cover& cover,
                   const SkinOptions& options) {
  Skins skins;
  if (fill_area.empty()) return skins;
  skins.sparse = SparsePart(fill_area, outline, cover, options);
  if (options.solid_below_area_mm2 > 0) {
    const MultiPolygon small = SmallOnes(skins.sparse, options.solid_below_area_mm2);
    if (!small.empty()) skins.sparse = Difference(skins.sparse, small);
  }
  if (skins.sparse == fill_area) return skins;
  skins.solid = skins.sparse.empty() ? fill_area : Difference(fill_area, skins.sparse);
  skins.top = Exposed(skins.solid, cover.above, outline, options.width_nm);
  if (!skins.top.empty()) skins.solid = Difference(skins.solid, skins.top);
  if (!cover.on_bed) {
    skins.bridge = Exposed(skins.solid, cover.below, outline, options.width_nm);
    if (!skins.bridge.empty()) skins.solid = Difference(skins.solid, skins.bridge);
  }
  return skins;
}

}  // namespace slicefarm::infill
