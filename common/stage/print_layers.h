#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"

namespace slicefarm {

/// The layers of a print: one for each height at which a layer of some stack ends, with all sections
/// that end there, by ascending stack; as high as from the layer below.
///
/// `parts`: layers bottom up, each with what ends at its height above its own bottom. `lifts_nm`: by
/// object, how high its part's bottom lies; fewer: 0. `added`: what planning adds.
/// Free of cost if nothing is lifted nor added; else O(n log n) in the number of sections.
std::vector<SlicedLayer> PrintLayers(std::vector<SlicedLayer> parts,
                                     std::span<const Coord> lifts_nm,
                                     std::vector<AddedStack> added);

/// How many layers that are.
size_t PrintLayerCount(std::span<const SlicedLayer> parts, std::span<const Coord> lifts_nm,
                       std::span<const AddedStack> added);

}  // namespace slicefarm
