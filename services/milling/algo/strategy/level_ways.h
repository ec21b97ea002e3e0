#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "processes/mill/model/milled_step.h"
#include "processes/mill/model/milling_options.h"
#include "services/milling/algo/strategy/free_area.h"

namespace slicefarm::milling {

/// Rings inside each other, at most: PrepareMilling refuses stock so wide.
inline constexpr int kMostRings = 4'000;

/// Roughing of a level: rings a stepover apart, from the outline of the area inwards. Every place
/// of the area is a stepover away from a ring at most.
///
/// In an area that reaches the outside of the stock, rings go from there inwards and then outwards
/// to the islands' walls; in a pocket, from its middle outwards. So each ring has at most a
/// stepover of stock on one side, but for the first. Parts of the area narrower than the minimum
/// width are left out. Cost: an offset for each ring. Once cancelled, no more rings are made: ask
/// the token.
std::vector<CutArea> RoughingWays(const FreeArea& level, const MillingOptions& options,
                                  const CancelToken& cancel = {});

/// Finishing of a level: the outlines of the area, along the part and along the outside.
std::vector<CutArea> FinishingWays(const FreeArea& level, const MillingOptions& options);

}  // namespace slicefarm::milling
