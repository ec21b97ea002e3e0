#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

/// `enable_extra_bridge_layer`: bridges above which the next layer is a bridge too.
enum class ExtraBridges : uint8_t { kNone, kExternal, kInternal, kAll };

/// Returns true if there is a second layer above bridges over air.
inline bool DoublesExternal(ExtraBridges extra) {
  return extra == ExtraBridges::kExternal || extra == ExtraBridges::kAll;
}

/// Returns true if there is a second layer above bridges over sparse infill.
inline bool DoublesInternal(ExtraBridges extra) {
  return extra == ExtraBridges::kInternal || extra == ExtraBridges::kAll;
}

/// Options of bridges. Member comments begin with the name of the setting.
struct BridgeOptions {
  double internal_angle_rad = 0;  ///< `internal_bridge_angle`; 0: a direction for each bridge
  /// `relative_bridge_angle`: the given directions are added to the computed ones
  bool relative = false;
  Coord width_nm = 0;  ///< `bridge_line_width`; 0: the nozzle, or solid_width_nm for flat lines
  ExtraBridges extra = ExtraBridges::kNone;

  friend bool operator==(const BridgeOptions&, const BridgeOptions&) = default;
};

}  // namespace slicefarm
