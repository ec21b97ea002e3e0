#include "services/slicing/algo/mesh_io/mesh_source.h"

#include "services/slicing/algo/mesh_io/mesh_reader.h"

namespace slicefarm::slicing {
namespace {

class DirectMeshSource : public MeshSource {
 public:
  absl::StatusOr<RawMesh> Read(std::string bytes, MeshFormat format, double coordinate_limit,
                               const CancelToken& cancel) const override {
    return ReadMesh(bytes, format, coordinate_limit, cancel);
  }
};

}  // namespace

std::unique_ptr<MeshSource> MakeDirectMeshSource() { return std::make_unique<DirectMeshSource>(); }

}  // namespace slicefarm::slicing
