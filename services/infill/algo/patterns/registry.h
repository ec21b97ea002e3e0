#pragma once

#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Returns the function of a pattern. This is the only table of patterns; sparse fill, solid fill,
/// the gallery, benchmarks and the tests of all patterns use it. Each pattern is one file of this
/// folder.
MakePattern* PatternOf(FillPattern pattern);

}  // namespace slicefarm::infill
