#pragma once

#include "absl/status/statusor.h"
#include "services/coordinator/run/blob_sweep.h"
#include "tests/sim/process.h"
#include "tests/sim/world.h"

namespace slicefarm::coordinator::sim {

/// Calls Sweep as a coordinator's thread does. The clock advances before each call of a store, and
/// all other events happen meanwhile. Errors: errors of Sweep; Cancelled if the coordinator dies
/// meanwhile.
absl::StatusOr<Swept> SweepInTime(World& world, Process& process, JobStore& jobs, int64_t now_us);

}  // namespace slicefarm::coordinator::sim
