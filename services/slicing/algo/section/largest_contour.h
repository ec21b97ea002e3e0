#pragma once

#include "common/model/layers/layer.h"

namespace slicefarm::slicing {

/// Reduces a section to the area inside its largest outer ring: the single loop of a spiral (spiral
/// vase). Regions are clipped to this area. The holes of the section are filled and added to the
/// first region. Cost: O(n) if the section is one island of one region without holes.
void KeepLargestContour(ObjectSection& section);

}  // namespace slicefarm::slicing
