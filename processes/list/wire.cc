#include "processes/list/wire.h"

#include <cstdlib>

#include "processes/engrave/wire/engrave_wire.h"
#include "processes/fdm/wire/fdm_wire.h"
#include "processes/laser/wire/laser_wire.h"
#include "processes/mill/wire/mill_wire.h"

namespace slicefarm {

const TaskWire& WireOf(Process process) {
  switch (process) {
    case Process::kFdm:
      return FdmWire();
    case Process::kLaser:
      return LaserWire();
    case Process::kMill:
      return MillWire();
    case Process::kEngrave:
      return EngraveWire();
  }
  std::abort();  // unreachable: all values of Process are handled
}

const TaskWire* WireOf(const v1::WorkStart& start) {
  for (const ProcessInfo& info : kProcesses)
    if (const TaskWire& wire = WireOf(info.process); wire.IsIn(start)) return &wire;
  return nullptr;
}

}  // namespace slicefarm
