#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/milling/algo/strategy/mill_steps.h"

namespace slicefarm::milling {

/// An area of a level.
struct AreaPlace {
  uint32_t level = 0;
  uint32_t area = 0;

  friend bool operator==(const AreaPlace&, const AreaPlace&) = default;
};

/// The order in which areas are cut: after all areas of the level above that they overlap, and else
/// as deep as can be before the next one, so that a pocket is finished before the tool goes on to
/// another. REQUIRES: levels go down. Cost: O(n m) for two areas of n and m points that do not
/// overlap but whose boxes do; less for the others.
std::vector<AreaPlace> CutOrder(std::span<const MilledStep> levels);

}  // namespace slicefarm::milling
