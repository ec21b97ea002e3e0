#pragma once

#include <string>
#include <vector>

#include "tests/load/generator/algo/run_report.h"

namespace slicefarm::load {

/// p50 to max of the latency over the load, as SVG: one point for each run, by ascending load,
/// which is the intended rate (of a closed loop: what it achieved). Under a load, what did not end
/// well there: failed and skipped requests in percent.
std::string LatencyPlot(const std::vector<RunReport>& runs);

}  // namespace slicefarm::load
