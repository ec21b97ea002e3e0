#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Machines that follow the host: Marlin's commands, slicefarm's own planner (jerk_planner.h).
const Firmware& JerkLimited();

}  // namespace slicefarm::motion
