#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Returns the wire format of milling tasks: v1::MillWork. All tasks of a job share everything
/// except the range. The result exists as long as the program.
const TaskWire& MillWire();

}  // namespace slicefarm
