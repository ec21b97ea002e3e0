#include "services/exposure/algo/scan/skins.h"

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm::exposure {
namespace {

/// Returns the part of the outline that at least one of the layers does not cover.
MultiPolygon Uncovered(const MultiPolygon& outline, std::span<const MultiPolygon* const> layers) {
  MultiPolygon uncovered;
  for (const MultiPolygon* layer : layers) {
    if (layer == nullptr || layer->empty()) return outline;
    if (*layer == outline) continue;
    uncovered = Union(uncovered, Difference(outline, *layer));
  }
  return uncovered;
}

MultiPolygon Skin(const MultiPolygon& outline, std::span<const MultiPolygon* const> layers,
                  Coord overlap_nm) {
  MultiPolygon skin = Uncovered(outline, layers);
  return skin.empty() || overlap_nm == 0 ? skin : Offset(skin, overlap_nm);
}

}  // namespace

SkinAreas PartSkins(const SkinAreas& insides, const MultiPolygon& outline,
                    const SkinNeighbours& neighbours, Coord overlap_nm) {
  const MultiPolygon down = Skin(outline, neighbours.below, overlap_nm);
  const MultiPolygon up = Skin(outline, neighbours.above, overlap_nm);
  SkinAreas areas;
  areas.core = insides.core;
  if (!up.empty()) {
    areas.upskin = Intersection(insides.upskin, up);
    areas.core = Difference(areas.core, up);
  }
  if (!down.empty()) {
    areas.downskin = Intersection(insides.downskin, down);
    areas.upskin = Difference(areas.upskin, down);
    areas.core = Difference(areas.core, down);
  }
  return areas;
}

}  // namespace slicefarm::exposure
