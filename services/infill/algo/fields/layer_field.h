#pragma once

#include "common/geometry/point.h"
#include "common/model/fields/density_field.h"
#include "services/infill/algo/fields/direction_field.h"
#include "services/infill/algo/fields/surface_distance.h"

namespace slicefarm::infill {

struct StreamMemo;

/// Density and direction fields of one layer of an object. All pointers must outlive this struct.
struct LayerField {
  const DensityField* density = nullptr;       ///< null: `plain_density` everywhere
  const DirectionField* directions = nullptr;  ///< null: the pattern has its own directions
  /// Distances to the surface; null if the density does not depend on them.
  const DistanceMap* to_surface = nullptr;
  bool across = false;  ///< true if the layer follows the directions perpendicular to the main ones
  StreamMemo* memo = nullptr;  ///< cached lines; null if the fields depend on the height
  double plain_density = 0;
  double z_mm = 0;

  /// Returns the density at a point of the layer.
  double DensityAt(double x_mm, double y_mm) const {
    if (density == nullptr) return plain_density;
    return density->At({x_mm, y_mm, z_mm}, to_surface == nullptr ? 0 : to_surface->At(x_mm, y_mm));
  }
  /// Returns the density at a point in nm.
  double DensityAt(Point p) const {
    return DensityAt(ToMm(static_cast<double>(p.x)), ToMm(static_cast<double>(p.y)));
  }
};

}  // namespace slicefarm::infill
