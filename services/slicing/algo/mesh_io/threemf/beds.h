#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"
#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"

namespace slicefarm::slicing::threemf {

/// Adds to the project one plate for each bed. PrusaSlicer 2.9 arranges its beds in one common
/// coordinate system.
///
/// The beds fill growing squares from the first bed, to the right and to the back. The distance
/// between beds is 30 % of the bed's diagonal, at most 100 mm. A bed's offset from the first bed is
/// subtracted from its instances. An instance belongs to the bed nearest to the instance's origin,
/// which PrusaSlicer keeps in the middle of the object. A note is added for instances on no bed.
/// With one bed, or if the bed's size is unknown, all instances stay on one plate.
void AddBeds(const std::vector<PlateSettings>& beds, Project& project, Notes& notes);

}  // namespace slicefarm::slicing::threemf
