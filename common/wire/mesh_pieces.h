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

v1::MeshSize SizeOf(const IndexedMesh& mesh);

/// Calls `send` with each piece of a mesh, until it returns false. Errors: OUT_OF_RANGE for
/// vertices that do not fit in 32 bits.
absl::Status ForEachPiece(const IndexedMesh& mesh,
                          const std::function<bool(const v1::MeshPiece&)>& send);

/// The other end: puts meshes together, whose pieces come one mesh after the other.
class MeshReader {
 public:
  /// Errors: REQUEST_MALFORMED; MESH_TOO_LARGE if they are announced to have more triangles than a
  /// job may have.
  static absl::StatusOr<MeshReader> Begin(std::vector<v1::MeshSize> sizes);

  /// Errors: REQUEST_MALFORMED for more than was announced, and for corners that no vertex is at.
  absl::Status Add(const v1::MeshPiece& piece);

  /// Errors: REQUEST_MALFORMED for less than was announced.
  absl::StatusOr<std::vector<IndexedMesh>> Finish();

 private:
  bool IsWhole() const;

  std::vector<v1::MeshSize> sizes_;
  std::vector<IndexedMesh> meshes_;
  size_t mesh_ = 0;  ///< being filled
};

}  // namespace slicefarm
