#pragma once

#include <chrono>
#include <cstdint>

#include "tests/load/generator/algo/run_report.h"
#include "tests/load/generator/client/scenario.h"

namespace slicefarm::load {

struct RunOptions {
  double rate_rps = 0;  ///< open loop at this rate; 0: closed loop
  std::chrono::duration<double> duration{30};
  std::chrono::duration<double> deadline{60};  ///< of each request with all its calls
  int in_flight = 512;  ///< requests at once; in an open loop, an arrival beyond is skipped
  bool retry = false;
  uint64_t seed = 0;  ///< of the arrivals
};

/// Puts the load on and waits until every request has ended. Fills in what the run knows: the rest
/// of the report is the caller's. REQUIRES: the scenario is prepared.
RunReport Run(const RunOptions& options, Scenario& scenario);

}  // namespace slicefarm::load
