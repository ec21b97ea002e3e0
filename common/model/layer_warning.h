#pragma once

#include <cstdint>

namespace slicefarm {

/// Deviation of one layer's result from the request.
struct LayerWarning {
  int32_t layer = 0;
  /// number of islands with walls of constant width, because kArachne failed
  int32_t plain_islands = 0;

  friend bool operator==(const LayerWarning&, const LayerWarning&) = default;
};

}  // namespace slicefarm
