#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

/// Order in which the loops or turns of a surface are printed.
enum class FillOrder : uint8_t {
  kNearest,  ///< the nearest next
  kOutward,  ///< begins in the middle
  kInward,   ///< begins at the edge
};

/// `center_of_surface_pattern`: middle of the spirals of top and bottom surfaces.
enum class SurfaceCenter : uint8_t {
  kObject,   ///< `each_assembly`: the middle of the object
  kBody,     ///< `each_model`: the middle of the connected body
  kSurface,  ///< `each_surface`: the middle of the surface
};

/// `top_surface_expansion_direction`: edges at which top surfaces grow.
enum class ExpansionDirection : uint8_t { kBoth, kInward, kOutward };

/// Options of top and bottom surfaces. Member comments begin with the name of the setting.
struct SurfaceOptions {
  double top_angle_rad = -1;     ///< `top_layer_direction`; below 0: as other solid infill
  double bottom_angle_rad = -1;  ///< `bottom_layer_direction`; below 0: as other solid infill
  FillOrder top_order = FillOrder::kNearest;     ///< setting top_surface_fill_order
  FillOrder bottom_order = FillOrder::kNearest;  ///< setting bottom_surface_fill_order
  SurfaceCenter center = SurfaceCenter::kObject;
  Coord expansion_nm = 0;         ///< setting top_surface_expansion
  Coord expansion_margin_nm = 0;  ///< setting top_surface_expansion_margin
  ExpansionDirection expansion_direction = ExpansionDirection::kBoth;

  friend bool operator==(const SurfaceOptions&, const SurfaceOptions&) = default;
};

}  // namespace slicefarm
