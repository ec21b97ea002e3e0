#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Tasks of milling: v1::MillWork, then the meshes of part and stock. Lives as long as the program.
const TaskWire& MillWire();

}  // namespace slicefarm
