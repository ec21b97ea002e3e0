#pragma once

#include <cstdint>

namespace slicefarm {

/// What a stage could not do as it was asked to, in one layer.
struct LayerWarning {
  int32_t layer = 0;
  int32_t plain_islands = 0;  ///< islands that fell back to walls of constant width

  friend bool operator==(const LayerWarning&, const LayerWarning&) = default;
};

}  // namespace slicefarm
