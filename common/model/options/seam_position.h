#pragma once

#include <cstdint>

namespace slicefarm {

/// Places where loops start.
enum class SeamPosition : uint8_t {
  kNearest,  ///< near the nozzle
  kRear,     ///< at the back, in line
  kAligned,  ///< in line up the object, at corners
  kRandom,   ///< anywhere, each loop elsewhere
  kHidden,   ///< in line, where the least is seen of it
};

}  // namespace slicefarm
