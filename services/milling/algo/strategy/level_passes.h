#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "processes/mill/model/milled_step.h"
#include "processes/mill/model/milling_options.h"
#include "services/milling/algo/strategy/free_area.h"

namespace slicefarm::milling {

/// Largest number of nested rings; PrepareMilling refuses wider stock.
inline constexpr int kMostRings = 4'000;

/// Returns the passes for roughing a level: rings a stepover apart, from the outline of the area
/// inwards. Every point of the area is at most a stepover away from a ring.
///
/// If the area reaches beyond the stock, rings are cut from the outside inwards, then the rings
/// around islands, the one at the island's wall last. In a pocket, rings are cut from
/// its middle outwards. So each ring except the first has at most a stepover of stock on one side.
/// Parts of the area narrower than the minimum width are left out. Cost: an offset for each ring.
/// After cancellation, no more rings are made, so callers must check the token.
std::vector<CutArea> RoughingPasses(const FreeArea& level, const MillingOptions& options,
                                    const CancelToken& cancel = {});

/// Returns the passes for finishing a level: the outlines of the free area, which follow the part,
/// and the outer boundary beside the stock.
std::vector<CutArea> FinishingPasses(const FreeArea& level, const MillingOptions& options);

}  // namespace slicefarm::milling
