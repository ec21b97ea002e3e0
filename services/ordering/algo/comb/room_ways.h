#pragma once

#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"

namespace slicefarm::ordering {

/// Leads a layer's travel round the bed's excluded areas: between its visits and between the paths
/// of a block, for all copies of the block alike. `room`: the bed without these areas; empty:
/// nothing is excluded. The ways between layers are motion's. Cost: O(legs * corners of the room).
void KeepInRoom(const MultiPolygon& room, OrderedLayer& layer);

}  // namespace slicefarm::ordering
