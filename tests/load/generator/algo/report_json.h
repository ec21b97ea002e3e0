#pragma once

#include <string>
#include <vector>

#include "tests/load/generator/algo/run_report.h"

namespace slicefarm::load {

/// The runs as JSON in the form of ghz's reports, so that what reads those reads these: one run is
/// an object, several are an array of them. Durations are nanoseconds where ghz has them so.
///
/// Unlike ghz's, every latency is over all requests that were started, failed ones too, and counts
/// from the intended start. What ghz has no place for stands under names of its own; tests/load
/// lists them.
/// Source: ghz, runner/reporter.go.
std::string ReportJson(const std::vector<RunReport>& runs);

/// Go's name of a status code, as ghz writes it: "DeadlineExceeded".
std::string_view GoCodeName(absl::StatusCode code);

}  // namespace slicefarm::load
