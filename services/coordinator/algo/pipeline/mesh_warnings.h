#pragma once

#include <string>
#include <vector>

#include "common/model/scene/mesh.h"

namespace slicefarm::coordinator {

/// Returns warnings about the defects of a mesh, one sentence each, for the owner of the mesh.
/// Empty for a closed mesh without defects.
std::vector<std::string> MeshWarnings(const MeshReport& mesh);

}  // namespace slicefarm::coordinator
