#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Bambu Lab's printers: Marlin's commands, with the comments and labels of Bambu Studio.
const Firmware& Bambu();

}  // namespace slicefarm::motion
