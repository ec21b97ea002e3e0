#pragma once

#include "absl/status/statusor.h"
#include "services/coordinator/run/blob_sweep.h"
#include "tests/sim/process.h"
#include "tests/sim/world.h"

namespace slicefarm::coordinator::sim {

/// Calls Sweep like the sweep thread of a coordinator. Before each call of a store, the simulated
/// clock advances and all other events up to that time happen. Errors: errors of Sweep; Cancelled
/// if the coordinator dies during the sweep.
absl::StatusOr<Swept> SweepInTime(World& world, Process& process, JobStore& jobs, int64_t now_us);

}  // namespace slicefarm::coordinator::sim
