#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "services/milling/algo/strategy/free_area.h"
#include "services/milling/algo/strategy/milling_options.h"

namespace slicefarm::milling {

/// One connected part of a level's free area, and the ways of the tip in it.
struct CutArea {
  PolygonWithHoles area;
  /// In the order of cutting, turned as the direction of cutting wants; closed without repeating
  /// the first point.
  std::vector<Polygon> ways;
};

/// Roughing of a level: rings a stepover apart, from the outline of the area inwards. Every place
/// of the area is a stepover away from a ring at most.
///
/// In an area that reaches the outside of the stock, rings go from there inwards and then outwards
/// to the islands' walls; in a pocket, from its middle outwards. So each ring has at most a
/// stepover of stock on one side, but for the first. Parts of the area narrower than the minimum
/// width are left out. Cost: an offset for each ring.
std::vector<CutArea> RoughingWays(const FreeArea& level, const MillingOptions& options);

/// Finishing of a level: the outlines of the area, along the part and along the outside.
std::vector<CutArea> FinishingWays(const FreeArea& level, const MillingOptions& options);

}  // namespace slicefarm::milling
