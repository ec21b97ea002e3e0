#pragma once

#include "common/geometry/polygon.h"
#include "common/model/options/adhesion_options.h"

namespace slicefarm::planning {

/// Returns the brim width that an object needs: 0 or 5 to 18 mm, but no more than the object's own
/// size.
///
/// The width grows with the risk of falling over: the height relative to the second moments of the
/// first layer, times the print speed. The width also grows with the risk of warping: the length
/// relative to the length that the material tolerates. Thin walls higher than 10 mm get 5 mm if
/// this rule gives them no brim.
///
/// `first_layer`: outlines of the first layer; the width is 0 if empty. `height_nm`: height of the
/// whole object. Source: the auto_brim rule of Bambu Studio and OrcaSlicer, applied to each object.
/// These programs apply it to each group of parts, and the rule for thin walls to each island.
Coord AutomaticBrimWidth(const AutomaticBrim& brim, const MultiPolygon& first_layer,
                         Coord height_nm);

}  // namespace slicefarm::planning
