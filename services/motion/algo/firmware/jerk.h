#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Machines that follow slicefarm's own motion plan (jerk_planner.h). Their commands are Marlin's.
const Firmware& JerkLimited();

}  // namespace slicefarm::motion
