#pragma once

#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/geometry/measure.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/transform.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"
#include "services/slicing/algo/topology/mesh_measure.h"

namespace slicefarm::slicing {

/// Converts a mesh to nanometres: transforms it, rounds it and welds it by exact position. Rounding
/// is half away from zero, so mirror images stay mirror images. Errors: OUT_OF_RANGE for
/// coordinates that cannot be rounded. Cost: O(n).
absl::StatusOr<IndexedMesh> TransformMesh(const RawMesh& raw, const Transform& transform);

/// Adds `by` to all vertices.
void MoveBy(IndexedMesh& mesh, const Vertex& by);

/// Returns the translation that moves a box to the object's origin: its middle to x = y = 0
/// (rounded down to nm), its bottom to z = -sunk_nm.
Vertex ToOrigin(const Extent& extent, Coord sunk_nm);

/// Returns OUT_OF_RANGE unless the coordinates of a box moved by ToOrigin fit 32-bit nanometres.
absl::Status CheckReach(const Extent& extent);

/// Transforms the mesh of a whole object and moves it to the object's origin (ToOrigin).
absl::StatusOr<IndexedMesh> PlaceMesh(const RawMesh& raw,
                                      const Transform& transform = Transform::Identity());

}  // namespace slicefarm::slicing
