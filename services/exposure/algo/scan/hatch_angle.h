#pragma once

#include <cstdint>

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the direction of a layer's hatch lines in degrees, in [0, 360): hatch_angle_deg plus
/// layer_rotation_deg per layer. For islands, this is the direction in even islands.
///
/// Lines within gas_window_deg of the gas flow or its opposite are rotated away from this
/// direction: by 90 degrees, or by 45 degrees for islands, which have lines in two directions. If
/// alternate_directions is off and jump_order is kAgainstGas, all lines are directed against the
/// flow.
double HatchAngle(const ExposureOptions& options, int32_t layer);

}  // namespace slicefarm::exposure
