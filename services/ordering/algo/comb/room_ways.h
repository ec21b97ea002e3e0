#pragma once

#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"

namespace slicefarm::ordering {

/// Leads a layer's travels around the bed's excluded areas: the travels between visits and the
/// travels between the paths of a block. All copies of a block share the same travels. `room`: the
/// bed without the excluded areas; empty if nothing is excluded. The motion service does this for
/// travels between layers. Cost: O(legs * corners of the room).
void KeepInRoom(const MultiPolygon& room, OrderedLayer& layer);

}  // namespace slicefarm::ordering
