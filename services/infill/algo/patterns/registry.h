#pragma once

#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// How a pattern is made: the one place that knows, for sparse fill, solid fill, the gallery,
/// benchmarks and the tests of all patterns. Each is one file of this folder.
MakePattern* PatternOf(FillPattern pattern);

}  // namespace slicefarm::infill
