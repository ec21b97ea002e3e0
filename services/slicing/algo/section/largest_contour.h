#pragma once

#include "common/model/layers/layer.h"

namespace slicefarm::slicing {

/// Leaves of a section what its largest outer ring encloses: the one loop that a spiral follows.
/// Regions are cut to it; what they leave in holes of the section belongs to the first of them.
/// Cost: O(n) where the section is one island without holes, of one region.
void KeepLargestContour(ObjectSection& section);

}  // namespace slicefarm::slicing
