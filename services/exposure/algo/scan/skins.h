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

/// Parts `area`, the inside of a section with `outline`: what is not covered by all layers above is
/// upskin, by all below downskin. Skins reach `overlap_nm` into the rest.
SkinAreas PartSkins(const MultiPolygon& area, const MultiPolygon& outline,
                    const SkinNeighbours& neighbours, Coord overlap_nm);

}  // namespace slicefarm::exposure
