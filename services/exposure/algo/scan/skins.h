#pragma once

#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Areas of a section. The core has the part above and below it. The upskin has no part above it,
/// the downskin no part below it.
struct SkinAreas {
  MultiPolygon core;
  MultiPolygon upskin;
  MultiPolygon downskin;  ///< has priority over upskin where both apply
};

/// Outlines of the layers next to a section. A nullptr is a missing layer: the whole section is
/// skin.
struct SkinNeighbours {
  std::span<const MultiPolygon* const> above;
  std::span<const MultiPolygon* const> below;
};

/// Divides the inside of a section with `outline` into core and skins. An area not covered by all
/// layers above is upskin; one not covered by all layers below is downskin. Skins extend by
/// `overlap_nm` into the core. `insides`: the area of the section that each kind may fill. These
/// areas differ only for rings: the kind's hatch distance sets the position of the outermost ring.
SkinAreas PartSkins(const SkinAreas& insides, const MultiPolygon& outline,
                    const SkinNeighbours& neighbours, Coord overlap_nm);

}  // namespace slicefarm::exposure
