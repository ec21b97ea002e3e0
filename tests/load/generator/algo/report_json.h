#pragma once

#include <string>
#include <vector>

#include "tests/load/generator/algo/run_report.h"

namespace slicefarm::load {

/// Returns the runs as JSON in the form of ghz's reports, so that readers of ghz's reports can read
/// them. One run is an object; several runs are an array of objects. Durations are in nanoseconds
/// where ghz uses nanoseconds.
///
/// In contrast to ghz, latencies cover all started requests, including failed ones, and count from
/// the intended start. Values that ghz does not have use names of their own; tests/load lists them.
/// Source: ghz, runner/reporter.go.
std::string ReportJson(const std::vector<RunReport>& runs);

/// Returns Go's name of a status code, as in ghz's reports: "DeadlineExceeded".
std::string_view GoCodeName(absl::StatusCode code);

}  // namespace slicefarm::load
