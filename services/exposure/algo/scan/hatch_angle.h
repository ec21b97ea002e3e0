#pragma once

#include <cstdint>

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the direction of a layer's hatch lines in degrees, in [0, 360): hatch_angle_deg plus
/// layer_rotation_deg per layer. For islands, this is the direction in even islands.
///
/// A line direction within gas_window_deg of the gas flow, or of its opposite, is rotated by 90
/// degrees. With islands it is rotated by 45 degrees, because islands have lines in two directions.
/// If alternate_directions is off and jump_order is kAgainstGas, all lines are directed against the
/// flow.
double HatchAngle(const ExposureOptions& options, int32_t layer);

}  // namespace slicefarm::exposure
