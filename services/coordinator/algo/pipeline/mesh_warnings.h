#pragma once

#include <string>
#include <vector>

#include "common/model/scene/mesh.h"

namespace slicefarm::coordinator {

/// What its owner should know about a mesh, in plain words, one sentence each; none for a closed,
/// clean mesh.
std::vector<std::string> MeshWarnings(const MeshReport& mesh);

}  // namespace slicefarm::coordinator
