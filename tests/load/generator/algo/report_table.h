#pragma once

#include <string>

#include "tests/load/generator/algo/run_report.h"

namespace slicefarm::load {

/// Returns the header line of the table of runs that the program prints.
std::string TableHeader();
/// Returns the row of a run: one line, then its errors. Adds a warning if the generator itself was
/// so late that the results are doubtful.
std::string TableRow(const RunReport& run);

}  // namespace slicefarm::load
