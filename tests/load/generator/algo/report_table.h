#pragma once

#include <string>

#include "tests/load/generator/algo/run_report.h"

namespace slicefarm::load {

/// For a terminal: one line a run, below it the errors, and a warning where the generator itself
/// was so late that its figures are in doubt.
std::string TableHeader();
std::string TableRow(const RunReport& run);

}  // namespace slicefarm::load
