#pragma once

#include "common/wire/task_wire.h"

namespace slicefarm {

const TaskWire& WireOf(Process process);

/// The wire of the process whose task a call begins with, or null: it begins with none.
const TaskWire* WireOf(const v1::WorkStart& start);

}  // namespace slicefarm
