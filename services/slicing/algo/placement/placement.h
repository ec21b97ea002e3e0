#pragma once

#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/geometry/measure.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/transform.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Extent of a mesh; min > max for a mesh without vertices.
struct Extent {
  Vertex min{INT64_MAX, INT64_MAX, INT64_MAX};
  Vertex max{INT64_MIN, INT64_MIN, INT64_MIN};

  void Add(const Extent& other);
};
Extent ExtentOf(const IndexedMesh& mesh);

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
