#pragma once

#include <string>
#include <vector>

#include "common/model/scene/mesh.h"

namespace slicefarm::coordinator {

/// Returns the defects of a mesh that its owner should know, one plain sentence each. Empty for a
/// closed mesh without defects.
std::vector<std::string> MeshWarnings(const MeshReport& mesh);

}  // namespace slicefarm::coordinator
