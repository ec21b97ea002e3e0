#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/mesh_file_contents.h"

namespace slicefarm::slicing {

/// From the bytes of a stranger's file to triangles that the stage may rely on. Which process looks
/// at the bytes is the source's own affair; the triangles are the same.
class MeshSource {
 public:
  virtual ~MeshSource() = default;

  /// Reads as ReadMeshFile does, whose errors it passes on; may add some of its own. Takes the
  /// bytes by value and frees them as early as it can. Safe to call from many threads.
  virtual absl::StatusOr<MeshFileContents> Read(std::string bytes, MeshFormat format,
                                                double coordinate_limit, ReadDepth depth,
                                                const CancelToken& cancel) const = 0;
};

/// ReadMeshFile in this process: for files that the user of the process trusts.
std::unique_ptr<MeshSource> MakeDirectMeshSource();

}  // namespace slicefarm::slicing
