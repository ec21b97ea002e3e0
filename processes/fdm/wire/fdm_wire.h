#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Tasks of filament printing: v1::FdmWork, then the outlines of its layers with their halo. Lives
/// as long as the program.
const TaskWire& FdmWire();

}  // namespace slicefarm
