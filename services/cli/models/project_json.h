#pragma once

#include <string>

#include "common/model/scene/scene.h"

namespace slicefarm::cli {

/// Returns a project as JSON. Settings have PrusaSlicer's names where they exist.
///
///   application, settings {key: value}, without_effect [text];
///   painted_objects [number of an object on which filaments are painted];
///   objects [{name, settings, parts [{name, role, mesh, first_triangle, triangle_count, to_object,
///             settings}], height_ranges [{from_mm, to_mm, settings}],
///             copies [{printable, placed, to_plate}]}];
///   plates [{number, name, settings, objects [{object, copy}]}].
///
/// Transforms are 12 numbers, 3x4, row by row, in mm. triangle_count = -1 means all triangles from
/// first_triangle on. `object`, `copy` and the numbers of objects count from 0. A project without
/// plates gets one plate with all copies.
std::string ProjectJson(const Project& project);

}  // namespace slicefarm::cli
