#pragma once

#include <string>

#include "common/model/scene/scene.h"

namespace slicefarm::cli {

/// A project as JSON, with settings under PrusaSlicer's names where it has one for them:
///
///   application, settings {key: value}, without_effect [text],
///   painted_objects [number of an object on which filaments are painted],
///   objects [{name, settings, parts [{name, role, mesh, first_triangle, triangle_count, to_object,
///             settings}], height_ranges [{from_mm, to_mm, settings}],
///             copies [{printable, placed, to_plate}]}],
///   plates [{number, name, settings, objects [{object, copy}]}]
///
/// Transforms are 12 numbers, 3x4, row by row, in mm; triangle_count -1: all from first_triangle
/// on. `object`, `copy` and the numbers of objects count from 0. A project without plates has one,
/// with all copies.
std::string ProjectJson(const Project& project);

}  // namespace slicefarm::cli
