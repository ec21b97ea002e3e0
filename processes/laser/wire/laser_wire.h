#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Tasks of lasers: v1::LaserWork, then the outlines of its layers with their halo. Lives as long
/// as the program.
const TaskWire& LaserWire();

}  // namespace slicefarm
