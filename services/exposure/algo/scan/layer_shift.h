#pragma once

#include <cstdint>

#include "common/geometry/point.h"
#include "common/model/options/exposure_options.h"

namespace slicefarm::exposure {

/// Where seams lie in a layer. All places of a period come in turn, as evenly as can be at any
/// number of layers (low-discrepancy sequences), so that no column of a part has a seam in each
/// layer.

/// By how much the lines and cells of a layer's hatch are moved; 0 in layer 0, and without
/// options.shift_grids.
Point GridShift(int32_t layer, double angle_deg, const ExposureOptions& options);

/// At which share of a piece's outermost ring its rings begin, in [0, 1).
double RingStart(int32_t layer);

/// Which choice of cuts into convex pieces is taken: DecomposeOptions::variant.
int32_t CutVariant(int32_t layer, const ExposureOptions& options);

}  // namespace slicefarm::exposure
