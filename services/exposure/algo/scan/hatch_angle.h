#pragma once

#include <cstdint>


namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// The direction of a layer's hatch lines in degrees, in [0, 360): hatch_angle_deg, turned by
/// layer_rotation_deg a layer. Of islands, that of the even ones.
///
/// Lines within gas_window_deg of the flow of gas, either way, are turned to run across it: by 90
/// degrees, or by 45 where islands have lines both ways. Lines that all run one way
/// (alternate_directions is off) run against the flow where jump_order is kAgainstGas.
double HatchAngle(const ExposureOptions& options, int32_t layer);

}  // namespace slicefarm::exposure
