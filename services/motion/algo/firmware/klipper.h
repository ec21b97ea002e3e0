#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

const Firmware& Klipper();

}  // namespace slicefarm::motion
