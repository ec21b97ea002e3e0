#pragma once

#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// What of a section's inside has the part above and below, and what has not.
struct SkinAreas {
  MultiPolygon core;
  MultiPolygon upskin;
  MultiPolygon downskin;  ///< goes before upskin where both
};

/// Outlines of the layers next to a section's; nullptr: there is none, all of it is skin.
struct SkinNeighbours {
  std::span<const MultiPolygon* const> above;
  std::span<const MultiPolygon* const> below;
};

/// Parts the inside of a section with `outline`: what is not covered by all layers above is upskin,
/// by all below downskin. Skins reach `overlap_nm` into the rest. `insides`: what each kind may
/// fill of the section; the same, but for rings, whose distance decides where the outermost lies.
SkinAreas PartSkins(const SkinAreas& insides, const MultiPolygon& outline,
                    const SkinNeighbours& neighbours, Coord overlap_nm);

}  // namespace slicefarm::exposure
