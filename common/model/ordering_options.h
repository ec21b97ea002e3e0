#pragma once

#include <cstdint>

namespace slicefarm {

enum class SeamPosition { kNearest, kRear, kAligned };

struct OrderingOptions {
  SeamPosition seam =
      SeamPosition::kAligned;  ///< seam_position; rear and aligned work through the layer plan
  bool external_perimeters_first = false;  ///< external_perimeters_first
  bool inner_outer_inner = false;          ///< inner_outer_inner: goes before the one above
  bool infill_first = false;               ///< infill_first
  int32_t improvement_moves =
      200'000;  ///< bound on the 2-opt moves tried per layer: work, not time

  friend bool operator==(const OrderingOptions&, const OrderingOptions&) = default;
};

}  // namespace slicefarm
