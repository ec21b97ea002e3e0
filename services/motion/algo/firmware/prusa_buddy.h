#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Prusa's Buddy boards (MK4, MINI, XL, CORE One): Marlin 2 with checks of its own.
const Firmware& PrusaBuddy();

}  // namespace slicefarm::motion
