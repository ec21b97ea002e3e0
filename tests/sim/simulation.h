#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "tests/sim/scenario.h"
#include "tests/sim/totals.h"

namespace slicefarm::coordinator::sim {

struct Outcome {
  std::optional<std::string> violation;  ///< the first promise that was broken, and when
  Totals totals;
};

/// Runs coordinators, workers and clients through what the seed has in store for them, on a clock
/// of its own: the same seed, the same steps. `trace` gets a line for each of them that matters.
/// Ends when all clients have what they wanted and all jobs have ended; that they do, at the latest
/// some minutes after the last fault, is a promise as well.
Outcome Simulate(uint64_t seed, const Variant& variant = {},
                 const std::function<void(const std::string&)>& trace = {});

}  // namespace slicefarm::coordinator::sim
