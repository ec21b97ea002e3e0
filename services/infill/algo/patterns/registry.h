#pragma once

#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Returns the function of a pattern. All code that uses patterns calls this function, most of it
/// through PiecesOfPattern: sparse fill, solid fill, the gallery, benchmarks and tests. Each
/// pattern is one file of this folder.
MakePattern* PatternOf(FillPattern pattern);

}  // namespace slicefarm::infill
