#pragma once

#include <string>
#include <vector>

#include "tests/load/generator/algo/run_report.h"

namespace slicefarm::load {

/// Returns an SVG plot of the latency (p50 to max) over the load, with one point per run, by
/// ascending load. The load is the intended rate; for a closed loop, the achieved rate. Below each
/// load is the percentage of failed and skipped requests.
std::string LatencyPlot(const std::vector<RunReport>& runs);

}  // namespace slicefarm::load
