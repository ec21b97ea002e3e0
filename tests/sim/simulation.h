#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "tests/sim/scenario.h"
#include "tests/sim/totals.h"

namespace slicefarm::coordinator::sim {

/// Outcome of a simulation.
struct Outcome {
  std::optional<std::string> violation;  ///< first violated rule of the farm, with its time
  Totals totals;
};

/// Simulates coordinators, workers and clients with the scenario of a seed, on a simulated clock.
/// The same seed gives the same steps. `trace` gets a line for each important step.
///
/// Ends when all clients have completed their plans and all jobs have ended. The simulation also
/// checks that this happens at most some minutes after the last fault.
Outcome Simulate(uint64_t seed, const Variant& variant = {},
                 const std::function<void(const std::string&)>& trace = {});

}  // namespace slicefarm::coordinator::sim
