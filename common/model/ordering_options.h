#pragma once

#include <cstdint>
#include <vector>

namespace slicefarm {

/// The order of the walls of one region.
struct WallOrder {
  bool external_perimeters_first = false;  ///< external_perimeters_first
  bool inner_outer_inner = false;          ///< inner_outer_inner: goes before the one above

  friend bool operator==(const WallOrder&, const WallOrder&) = default;
};

struct OrderingOptions {
  bool infill_first = false;  ///< infill_first
  int32_t improvement_moves =
      200'000;  ///< bound on the 2-opt moves tried per layer: work, not time
  std::vector<WallOrder> walls = {{}};  ///< by region

  friend bool operator==(const OrderingOptions&, const OrderingOptions&) = default;
};

}  // namespace slicefarm
