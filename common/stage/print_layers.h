#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"

namespace slicefarm {

/// Returns the layers of a print: one for each height at which a layer of some stack ends. A layer
/// contains all sections that end at its height, by ascending stack. Its height is the distance
/// from the layer below.
///
/// `parts`: layers from the bottom up, with the sections that end at a height above their own
/// bottom. `lifts_nm`: height of each object's bottom; 0 for objects beyond the end of the list.
/// `added`: stacks that planning adds. Cost: none if nothing is lifted or added; otherwise O(n log
/// n) in the number of sections.
std::vector<SlicedLayer> PrintLayers(std::vector<SlicedLayer> parts,
                                     std::span<const Coord> lifts_nm,
                                     std::vector<AddedStack> added);

/// Returns the number of layers that PrintLayers would return.
size_t PrintLayerCount(std::span<const SlicedLayer> parts, std::span<const Coord> lifts_nm,
                       std::span<const AddedStack> added);

}  // namespace slicefarm
