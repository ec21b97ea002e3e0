#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Klipper, with the limits and macros of its own host.
const Firmware& Klipper();

}  // namespace slicefarm::motion
