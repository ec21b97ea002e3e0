#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Returns the wire format of FDM tasks: v1::FdmWork, then the outlines of the layers with their
/// halo. The result exists as long as the program.
const TaskWire& FdmWire();

}  // namespace slicefarm
