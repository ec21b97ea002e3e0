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

/// Brings a mesh to nanometres: transformed, rounded (half away from zero, so mirror images stay
/// mirror images), welded by exact position. Errors: OUT_OF_RANGE for coordinates that cannot be
/// rounded. Cost: O(n).
absl::StatusOr<IndexedMesh> TransformMesh(const RawMesh& raw, const Transform& transform);

void MoveBy(IndexedMesh& mesh, const Vertex& by);

/// What moves a box to where objects are cut: the middle over x = y = 0 (rounded down to nm), the
/// bottom at z = -sunk_nm.
Vertex ToOrigin(const Extent& extent, Coord sunk_nm);

/// OUT_OF_RANGE unless a box, so moved, fits 32-bit nanometres.
absl::Status CheckReach(const Extent& extent);

/// Both at once, for a mesh that is an object by itself.
absl::StatusOr<IndexedMesh> PlaceMesh(const RawMesh& raw,
                                      const Transform& transform = Transform::Identity());

}  // namespace slicefarm::slicing
