#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Firmware of machines without an extruder. The motion service never writes programs for them;
/// other stages do.
const Firmware& Grbl();

}  // namespace slicefarm::motion
