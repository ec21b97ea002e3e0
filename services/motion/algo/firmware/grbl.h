#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Of machines without extruder. Its programs come from other stages; nothing is written
/// for it here.
const Firmware& Grbl();

}  // namespace slicefarm::motion
