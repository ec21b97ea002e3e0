#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Marlin 2 and its forks, Prusa's among them.
const Firmware& Marlin2();
/// Marlin 1: one acceleration for printing and travel.
const Firmware& MarlinLegacy();

}  // namespace slicefarm::motion
