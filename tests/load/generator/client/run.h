#pragma once

#include <chrono>
#include <cstdint>

#include "tests/load/generator/algo/run_report.h"
#include "tests/load/generator/client/scenario.h"

namespace slicefarm::load {

/// Options of a run.
struct RunOptions {
  double rate_rps = 0;  ///< rate of an open loop; 0: closed loop
  std::chrono::duration<double> duration{30};
  std::chrono::duration<double> deadline{60};  ///< deadline of each request with all its calls
  /// Largest number of requests in flight; an open loop skips arrivals beyond it.
  int in_flight = 512;
  bool retry = false;
  uint64_t seed = 0;  ///< seed of the arrivals
};

/// Runs the load and waits until every request has ended. Fills in the report except for the values
/// that only the caller has. REQUIRES: the scenario is prepared.
RunReport Run(const RunOptions& options, Scenario& scenario);

}  // namespace slicefarm::load
