#pragma once

#include "absl/status/statusor.h"
#include "services/coordinator/run/blob_sweep.h"
#include "tests/sim/process.h"
#include "tests/sim/world.h"

namespace slicefarm::coordinator::sim {

/// Sweep, as a coordinator's thread calls it: before each call of a store time passes, in which
/// everything else goes on. Errors: Sweep's, and Cancelled if the coordinator dies meanwhile.
absl::StatusOr<Swept> SweepInTime(World& world, Process& process, JobStore& jobs, int64_t now_us);

}  // namespace slicefarm::coordinator::sim
