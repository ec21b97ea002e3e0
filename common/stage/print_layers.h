#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"

namespace slicefarm {

/// Returns the layers of a print: one for each height at which a layer of some stack ends. A layer
/// contains all sections that end at its height, sorted by stack id. The layer's height is the
/// distance from the top of the layer below.
///
/// `parts`: layers of the parts from the bottom up, as if the bottom of each object were on the
/// bed. `lifts_nm`: height of each object's bottom above the bed, indexed by object; missing
/// entries are 0. `added`: stacks that planning adds. Cost: none if nothing is lifted or added;
/// otherwise O(n log n) for n sections.
std::vector<SlicedLayer> PrintLayers(std::vector<SlicedLayer> parts,
                                     std::span<const Coord> lifts_nm,
                                     std::vector<AddedStack> added);

/// Returns the number of layers that PrintLayers would return.
size_t PrintLayerCount(std::span<const SlicedLayer> parts, std::span<const Coord> lifts_nm,
                       std::span<const AddedStack> added);

}  // namespace slicefarm
