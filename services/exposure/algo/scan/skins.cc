#include "services/exposure/algo/scan/skins.h"

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm::exposure {
namespace {

/// What of the outline one of the layers does not cover.
MultiPolygon Uncovered(const MultiPolygon& outline, std::span<const MultiPolygon* const> layers) {
  MultiPolygon uncovered;
  for (const MultiPolygon* layer : layers) {
    if (layer == nullptr || layer->empty()) return outline;
    if (*layer == outline) continue;
    uncovered = Union(uncovered, Difference(outline, *layer));
  }
  return uncovered;
}

MultiPolygon Skin(const MultiPolygon& area, const MultiPolygon& outline,
                  std::span<const MultiPolygon* const> layers, Coord overlap_nm) {
  MultiPolygon skin = Uncovered(outline, layers);
  if (skin.empty()) return skin;
  if (overlap_nm > 0) skin = Offset(skin, overlap_nm);
  return Intersection(area, skin);
}

}  // namespace

SkinAreas PartSkins(const MultiPolygon& area, const MultiPolygon& outline,
                    const SkinNeighbours& neighbours, Coord overlap_nm) {
  SkinAreas areas;
  areas.downskin = Skin(area, outline, neighbours.below, overlap_nm);
  areas.upskin = Skin(area, outline, neighbours.above, overlap_nm);
  areas.core = area;
  if (!areas.downskin.empty()) {
    areas.core = Difference(areas.core, areas.downskin);
    areas.upskin = Difference(areas.upskin, areas.downskin);
  }
  if (!areas.upskin.empty()) areas.core = Difference(areas.core, areas.upskin);
  return areas;
}

}  // namespace slicefarm::exposure
