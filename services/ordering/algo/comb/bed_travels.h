#pragma once

#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"

namespace slicefarm::ordering {

/// Adds corners to a layer's travels so that they avoid the bed's excluded areas. Changes the
/// travels between the visits of a pass, and the travels between the paths of a block. All copies
/// of a block share its inner travels, so these avoid the areas of every copy. `travel_area`: the
/// bed without the excluded areas; empty if nothing is excluded. The motion service leads the
/// travels between layers. Cost: O(travels * corners of `travel_area`).
void KeepInTravelArea(const MultiPolygon& travel_area, OrderedLayer& layer);

}  // namespace slicefarm::ordering
