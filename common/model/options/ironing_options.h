#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

/// `ironing_type`: surfaces that are ironed.
enum class IroningType : uint8_t {
  kTop,      ///< all top surfaces
  kTopmost,  ///< top surfaces of an object's last layer
  kSolid,    ///< all solid infill
};

/// Options of ironing: the nozzle smooths a printed surface by a second pass with little plastic.
struct IroningOptions {
  bool enabled = false;                  ///< settings ironing and support_ironing
  IroningType type = IroningType::kTop;  ///< setting ironing_type
  double flow = 0.15;  ///< `ironing_flowrate`: share of the plastic that would fill the layer
  Coord spacing_nm = 100'000;  ///< `ironing_spacing`: distance of the ironing lines
  Coord inset_nm = 0;          ///< `ironing_inset`: distance from the part's edge; 0: half a nozzle
  bool concentric = false;     ///< `ironing_pattern`: lines along the edge
  /// `ironing_angle`: angle between ironing lines and solid lines; below 0: 0
  double angle_rad = 0;
  /// `ironing_angle_fixed`: angle_rad is measured from the x axis and is the same in all layers
  bool fixed_angle = false;
  /// `ironing_expansion`: distance by which the ironed area extends beyond the surface
  Coord expansion_nm = 0;

  friend bool operator==(const IroningOptions&, const IroningOptions&) = default;
};

}  // namespace slicefarm
