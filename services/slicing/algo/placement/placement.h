#pragma once

#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/geometry/measure.h"
#include "common/model/mesh.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Extent of a mesh; min > max for a mesh without vertices.
struct Extent {
  Vertex min{INT64_MAX, INT64_MAX, INT64_MAX};
  Vertex max{INT64_MIN, INT64_MIN, INT64_MIN};
};
Extent ExtentOf(const IndexedMesh& mesh);

/// Errors: SETTING_OUT_OF_RANGE for units, scale or angles that are not finite, or not above zero.
absl::Status CheckPlacement(const Placement& placement);

/// The largest absolute coordinate, in the units of the file, that `placement` leaves within
/// limits.h's 10 m.
double CoordinateLimit(const Placement& placement);

/// Brings a mesh to nanometres: units, scale, rotation about x, y, z in this order, rounding (half
/// away from zero, so mirror images stay mirror images), welding by exact position. The result
/// stands on z = 0 with the middle of its box at x = y = 0 (rounded down to nm).
///
/// The rotation's sines are computed from + and * alone, so they have the same bits on every
/// machine, and right angles are exact. Errors: SETTING_OUT_OF_RANGE for units, scale or angles
/// that are not finite or not above zero; OUT_OF_RANGE if the placed part does not fit 32-bit
/// nanometres. Cost: O(n).
absl::StatusOr<IndexedMesh> PlaceMesh(const RawMesh& raw, const Placement& placement);

}  // namespace slicefarm::slicing
