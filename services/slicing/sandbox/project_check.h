#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "common/model/scene/scene.h"

namespace slicefarm::slicing {

/// Returns the first reason why a project cannot come from a correct reader; empty if there is
/// none. The function checks counts and texts against limits.h. It also checks numbers,
/// enumerators, and indices into the project itself.
///
/// `triangles`: number of triangles of each mesh of the file, used to check the parts' ranges;
/// nullopt if the meshes were not read.
std::string_view FaultOf(const Project& project,
                         const std::optional<std::span<const int64_t>>& triangles);

}  // namespace slicefarm::slicing
