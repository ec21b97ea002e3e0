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
/// In an area that reaches the outside of the stock, rings go from the outside inwards, then
/// outwards to the walls of islands. In a pocket, they go from its middle outwards. So each ring
/// except the first has at most a stepover of stock on one side. Parts of the area narrower than
/// the minimum width are left out. Cost: an offset for each ring. After cancellation, no more rings
/// are made, so callers must check the token.
std::vector<CutArea> RoughingPasses(const FreeArea& level, const MillingOptions& options,
                                    const CancelToken& cancel = {});

/// Returns the passes for finishing a level: the outlines of the area, along the part and along the
/// outside.
std::vector<CutArea> FinishingPasses(const FreeArea& level, const MillingOptions& options);

}  // namespace slicefarm::milling
