#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Returns the wire format of engraving tasks: v1::EngraveWork. All tasks of a job share everything
/// except the range. The result exists as long as the program.
const TaskWire& EngraveWire();

}  // namespace slicefarm
