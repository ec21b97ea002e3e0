#pragma once

#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"

namespace slicefarm::ordering {

/// Leads a layer's travels around the bed's excluded areas: the travels between visits and the
/// travels between the paths of a block. All copies of a block share the travels inside the block.
/// `room`: the bed without the excluded areas; empty if nothing is excluded. For travels between
/// layers, the motion service does the same. Cost: O(legs * corners of `room`).
void KeepInRoom(const MultiPolygon& room, OrderedLayer& layer);

}  // namespace slicefarm::ordering
