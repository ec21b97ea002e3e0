#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/mesh_file_contents.h"

namespace slicefarm::slicing {

/// Converts the bytes of an untrusted file to checked triangles. Implementations differ in the
/// operating system process that reads the bytes; the triangles are the same.
class MeshSource {
 public:
  virtual ~MeshSource() = default;

  /// Reads as ReadMeshFile does and returns its errors. Implementations may return more errors.
  /// Takes the bytes by value and frees them as early as possible. Safe to call from several
  /// threads.
  virtual absl::StatusOr<MeshFileContents> Read(std::string bytes, MeshFormat format,
                                                double coordinate_limit, ReadDepth depth,
                                                const CancelToken& cancel) const = 0;
};

/// Returns a source that calls ReadMeshFile in this program, for files that the program's user
/// trusts.
std::unique_ptr<MeshSource> MakeDirectMeshSource();

}  // namespace slicefarm::slicing
