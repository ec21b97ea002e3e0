#pragma once

#include <cstdint>

namespace slicefarm {

/// Shortcoming of a stage's result in one layer, compared with the request.
struct LayerWarning {
  int32_t layer = 0;
  int32_t plain_islands = 0;  ///< number of islands with walls of constant width as a fallback

  friend bool operator==(const LayerWarning&, const LayerWarning&) = default;
};

}  // namespace slicefarm
