#pragma once

#include "common/geometry/polygon.h"
#include "common/model/options/adhesion_options.h"

namespace slicefarm::planning {

/// How wide a brim an object needs: the wider, the taller it is by what resists its falling over
/// (the second moments of its first layer) and the faster it is printed, and the longer it is by
/// what its material stands without warping; 0, or 5 to 18 mm, but no more than the object's own
/// size. Thin walls higher than 10 mm get 5 mm where they would get none.
/// `first_layer`: its outlines; empty: 0. `height_nm`: of the whole object.
/// Source: the rule of Bambu Studio and OrcaSlicer for auto_brim, by object (there by groups of
/// parts, and the last sentence by island).
Coord AutomaticBrimWidth(const AutomaticBrim& brim, const MultiPolygon& first_layer,
                         Coord height_nm);

}  // namespace slicefarm::planning
