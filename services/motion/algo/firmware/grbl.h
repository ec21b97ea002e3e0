#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Of lasers and mills: it has no extruder. Its programs come from other stages; nothing is written
/// for it here.
const Firmware& Grbl();

}  // namespace slicefarm::motion
