#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// RepRapFirmware 3 (Duet).
const Firmware& RepRap();

}  // namespace slicefarm::motion
