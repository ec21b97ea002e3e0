#pragma once

#include <vector>

#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/lines/scan_lines.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Returns the families of straight lines that form a pattern, including lines side by side
/// (PatternOptions::lines); empty if the pattern is not formed by such families.
std::vector<LineFamily> LineFamiliesOf(FillPattern pattern, const PatternContext& context);

}  // namespace slicefarm::infill
