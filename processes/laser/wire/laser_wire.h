#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Returns the wire format of laser tasks: v1::LaserWork, then the outlines of the layers with
/// their halo. The result exists as long as the program.
const TaskWire& LaserWire();

}  // namespace slicefarm
