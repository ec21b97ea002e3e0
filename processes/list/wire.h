#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Returns the wire format of the process's tasks.
const TaskWire& WireOf(Process process);

/// Returns the wire format of the process that `start` belongs to, or null if `start` contains no
/// task.
const TaskWire* WireOf(const v1::WorkStart& start);

}  // namespace slicefarm
