#pragma once

#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Areas of a section, each with its own exposure. The core has material above and below it. The
/// upskin has no material above it, the downskin none below it.
struct SkinAreas {
  MultiPolygon core;
  MultiPolygon upskin;
  MultiPolygon downskin;  ///< has priority over upskin where both apply
};

/// Outlines of the layers above and below a section. If an outline is nullptr or empty, this layer
/// is missing: the whole section is then upskin (`above`) or downskin (`below`).
struct SkinNeighbours {
  std::span<const MultiPolygon* const> above;
  std::span<const MultiPolygon* const> below;
};

/// Divides a section with `outline` into core and skins. An area that is not covered by all layers
/// above is upskin; an area not covered by all layers below is downskin. Skins extend by
/// `overlap_nm` into the core. `insides`: for each kind, the area that its hatch or rings may fill.
/// The three areas differ only for rings, because the outermost ring's position depends on the
/// kind's hatch distance.
SkinAreas PartSkins(const SkinAreas& insides, const MultiPolygon& outline,
                    const SkinNeighbours& neighbours, Coord overlap_nm);

}  // namespace slicefarm::exposure
