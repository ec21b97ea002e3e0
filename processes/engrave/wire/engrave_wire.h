#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

/// Tasks of engraving: v1::EngraveWork, all of which but the range is in common. Lives as long as
/// the program.
const TaskWire& EngraveWire();

}  // namespace slicefarm
