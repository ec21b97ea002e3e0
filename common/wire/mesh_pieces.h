#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/mesh.h"
#include "slicefarm/v1/geometry.pb.h"

namespace slicefarm {

/// Returns the counts of a mesh's vertices and triangles.
v1::MeshSize SizeOf(const IndexedMesh& mesh);

/// Calls `send` with each piece of a mesh, until `send` returns false. Errors: OUT_OF_RANGE for
/// coordinates that do not fit in 32 bits.
absl::Status ForEachPiece(const IndexedMesh& mesh,
                          const std::function<bool(const v1::MeshPiece&)>& send);

/// Assembles meshes from their pieces. All pieces of a mesh must arrive before the pieces of the
/// next mesh.
class MeshReader {
 public:
  /// Creates a reader for meshes of the announced sizes. Errors: REQUEST_MALFORMED for invalid
  /// sizes; MESH_TOO_LARGE if the sizes announce more triangles than a job may have.
  static absl::StatusOr<MeshReader> Begin(std::vector<v1::MeshSize> sizes);

  /// Adds a piece. Errors: REQUEST_MALFORMED for more data than announced, and for vertex indices
  /// out of range.
  absl::Status Add(const v1::MeshPiece& piece);

  /// Returns the meshes. Errors: REQUEST_MALFORMED for less data than announced.
  absl::StatusOr<std::vector<IndexedMesh>> Finish();

 private:
  bool IsWhole() const;

  std::vector<v1::MeshSize> sizes_;
  std::vector<IndexedMesh> meshes_;
  size_t mesh_ = 0;  ///< index of the mesh to which the next piece belongs
};

}  // namespace slicefarm
