#pragma once

#include <cstdint>

namespace slicefarm {

/// Position at which loops start and end.
enum class SeamPosition : uint8_t {
  kNearest,  ///< point near the nozzle
  kRear,     ///< vertical line at the rear
  kAligned,  ///< vertical line along the object, at corners
  kRandom,   ///< random point for each loop
  kHidden,   ///< vertical line where the seam is least visible
};

}  // namespace slicefarm
