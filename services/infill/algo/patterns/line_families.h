#pragma once

#include <vector>

#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/lines/scan_lines.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// The families of straight lines that a pattern is made of. None: it is made of others.
std::vector<LineFamily> LineFamiliesOf(FillPattern pattern, const PatternPlace& place);

}  // namespace slicefarm::infill
