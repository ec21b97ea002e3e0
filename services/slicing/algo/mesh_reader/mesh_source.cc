#include "services/slicing/algo/mesh_reader/mesh_source.h"

#include "services/slicing/algo/mesh_reader/mesh_reader.h"

namespace slicefarm::slicing {
namespace {

class DirectMeshSource : public MeshSource {
 public:
  absl::StatusOr<MeshFileContents> Read(std::string bytes, MeshFormat format,
                                        double coordinate_limit, ReadDepth depth,
                                        const CancelToken& cancel) const override {
    return ReadMeshFile(bytes, format, coordinate_limit, depth, cancel);
  }
};

}  // namespace

std::unique_ptr<MeshSource> MakeDirectMeshSource() { return std::make_unique<DirectMeshSource>(); }

}  // namespace slicefarm::slicing
