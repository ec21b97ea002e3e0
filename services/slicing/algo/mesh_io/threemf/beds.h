#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"
#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"

namespace slicefarm::slicing::threemf {

/// Gives the project a plate for each of the beds that PrusaSlicer 2.9 has in one space. They fill
/// growing squares from the first one to the right and to the back, and are 30% of a bed's diagonal
/// apart, at most 100 mm: that is taken off their instances again. An instance is on the bed that
/// its origin, which PrusaSlicer keeps in the middle of the object, is nearest to. What is on none
/// is noted. With one bed, and where it is not known, all stays on one.
void AddBeds(const std::vector<PlateSettings>& beds, Project& project, Notes& notes);

}  // namespace slicefarm::slicing::threemf
