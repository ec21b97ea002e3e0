#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "common/model/scene/scene.h"

namespace slicefarm::slicing {

/// What keeps a project from being one that reading a file can give; empty: nothing does. Checked
/// are counts and texts against limits.h, numbers, enumerators, and indices into the project
/// itself. `triangles`: of each mesh of the file, and then parts must lie within them; nothing if
/// the meshes were not read.
std::string_view FaultOf(const Project& project,
                         const std::optional<std::span<const int64_t>>& triangles);

}  // namespace slicefarm::slicing
