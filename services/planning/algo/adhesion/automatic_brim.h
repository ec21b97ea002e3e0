#pragma once

#include "common/geometry/polygon.h"
#include "common/model/options/adhesion_options.h"

namespace slicefarm::planning {

/// Returns the brim width that an object needs, in nm: 0 or 5 to 18 mm, but no more than the larger
/// side of the object's bounding box.
///
/// The width grows with the risk of falling over: the height relative to the second moments of the
/// first layer, times the print speed. It also grows with the risk of warping: the length relative
/// to the length that the material tolerates. If the result is 0, thin walls higher than 10 mm get
/// 5 mm.
///
/// `first_layer`: outlines of the first layer; the width is 0 if empty. `height_nm`: height of the
/// whole object. Source: the auto_brim rule of Bambu Studio and OrcaSlicer, applied to each object.
/// These programs apply it to each group of parts, and the rule for thin walls to each island.
Coord AutomaticBrimWidth(const AutomaticBrim& brim, const MultiPolygon& first_layer,
                         Coord height_nm);

}  // namespace slicefarm::planning
