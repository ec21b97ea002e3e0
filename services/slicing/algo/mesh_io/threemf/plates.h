#pragma once

#include <map>
#include <vector>

#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"
#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"

namespace slicefarm::slicing::threemf {

/// Project instances of the build items of each model object, in the order of the items.
using ItemsOfObject = std::map<ResourceId, std::vector<ProjectPlate::Member>>;

/// Gives the project its plates. Bambu Studio and OrcaSlicer arrange them in one common space: in
/// rows of ceil(sqrt(count)) plates, 1.2 beds apart, to the right and then towards the front. The
/// offset of a plate is subtracted from its instances.
///
/// If the bed is unknown, instances of the second and later plates are not placed. Instances on no
/// plate or on two plates are noted.
void AddPlates(const std::vector<PlateSettings>& plates, const ItemsOfObject& items,
               Project& project, Notes& notes);

}  // namespace slicefarm::slicing::threemf
