#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Bambu Lab's printers: Marlin's commands, Bambu Studio's comments and labels.
const Firmware& Bambu();

}  // namespace slicefarm::motion
