#pragma once

#include <cstdint>

#include "common/base/shared/shared_text.h"

namespace slicefarm {

/// `dont_filter_internal_bridges`: skins over sparse infill that are bridged, by their width.
enum class SparseBridgeFilter : uint8_t {
  kWide,    ///< `disabled`: skins wider than the distance of the lines below
  kMedium,  ///< `limited`: skins wider than half of this distance
  kAll,     ///< `nofilter`: all skins
};

/// Options of skins and of other solid infill. Member comments begin with the name of the setting.
struct SolidOptions {
  double top_density = 1;     ///< setting top_surface_density
  double bottom_density = 1;  ///< setting bottom_surface_density
  /// `detect_narrow_internal_solid_infill`: narrow parts inside the object get loops
  bool narrow_loops = false;
  SparseBridgeFilter bridges = SparseBridgeFilter::kWide;
  /// `elefant_foot_layers_density`: density of solid infill inside the object in its second layer;
  /// it rises to 1 over foot_layers
  double foot_density = 1;
  int32_t foot_layers = 1;  ///< number of layers with the elephant foot compensation
  /// `extra_solid_infills`: canonical text (solid_layers.h). Empty: no such layers.
  SharedText extra_layers = {};

  friend bool operator==(const SolidOptions&, const SolidOptions&) = default;
};

}  // namespace slicefarm
