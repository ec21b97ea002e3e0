#pragma once

#include <string>
#include <vector>

#include "common/model/options/settings.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config::fdm {

/// Returns notes about settings of an object's parts and ranges that have no effect because other
/// settings switch them off. See ProcessSettings::UnmetNeedsOf.
std::vector<std::string> NeedsOfObject(const SceneObject& object, const JobRows& settings);

}  // namespace slicefarm::config::fdm
