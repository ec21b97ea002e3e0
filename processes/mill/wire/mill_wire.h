#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Tasks of milling: v1::MillWork, all of which but the range is in common. Lives as long as the
/// program.
const TaskWire& MillWire();

}  // namespace slicefarm
