#pragma once

#include <map>
#include <vector>

#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"
#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"

namespace slicefarm::slicing::threemf {

/// Project instances of each model object, one per build item of the object, in the order of the
/// items.
using ItemsOfObject = std::map<ResourceId, std::vector<ProjectPlate::Member>>;

/// Adds to the project one plate for each of `plates`. Bambu Studio and OrcaSlicer arrange plates
/// in one common coordinate system: in rows of ceil(sqrt(count)) plates, 1.2 beds apart, to the
/// right and then towards the front. The offset of a plate is subtracted from its instances.
///
/// If the bed's size is unknown, instances of the second and later plates get no position. A note
/// is added for instances on no plate or on two plates.
void AddPlates(const std::vector<PlateSettings>& plates, const ItemsOfObject& items,
               Project& project, Notes& notes);

}  // namespace slicefarm::slicing::threemf
