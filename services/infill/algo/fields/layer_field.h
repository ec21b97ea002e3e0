#pragma once

#include "common/geometry/point.h"
#include "common/model/fields/density_field.h"
#include "services/infill/algo/fields/direction_field.h"
#include "services/infill/algo/fields/surface_distance.h"

namespace slicefarm::infill {

struct StreamMemo;

/// What fields say about one layer of an object. What it points to must outlive it.
struct LayerField {
  const DensityField* density = nullptr;       ///< none: `plain_density` everywhere
  const DirectionField* directions = nullptr;  ///< none: the pattern goes its own way
  const DistanceMap* to_surface = nullptr;     ///< for densities that depend on it
  bool across = false;                         ///< the layer follows the other family of them
  StreamMemo* memo = nullptr;                  ///< of fields that are the same at all heights
  double plain_density = 0;
  double z_mm = 0;

  double DensityAt(double x_mm, double y_mm) const {
    if (density == nullptr) return plain_density;
    return density->At({x_mm, y_mm, z_mm}, to_surface == nullptr ? 0 : to_surface->At(x_mm, y_mm));
  }
  double DensityAt(Point p) const {
    return DensityAt(ToMm(static_cast<double>(p.x)), ToMm(static_cast<double>(p.y)));
  }
};

}  // namespace slicefarm::infill
