#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Firmware of machines without an extruder. Other stages write its programs, so nothing is written
/// for it here.
const Firmware& Grbl();

}  // namespace slicefarm::motion
