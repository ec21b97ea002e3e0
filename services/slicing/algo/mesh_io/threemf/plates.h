#pragma once

#include <map>
#include <vector>

#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"
#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"

namespace slicefarm::slicing::threemf {

/// Where in the project the build items of each object of the model went, in their order.
using ItemsOfObject = std::map<ResourceId, std::vector<ProjectPlate::Member>>;

/// Gives the project its plates. Bambu Studio and OrcaSlicer lay them side by side in one space, in
/// rows of ceil(sqrt(count)), each 1.2 beds from the next, to the right and then towards the front:
/// that is taken off their instances again. Where the bed is not known, instances of the second and
/// later plates have no place. What is on no plate, or on two, is noted.
void AddPlates(const std::vector<PlateSettings>& plates, const ItemsOfObject& items,
               Project& project, Notes& notes);

}  // namespace slicefarm::slicing::threemf
