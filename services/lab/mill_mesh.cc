#include "services/lab/mill_mesh.h"

#include "common/model/limits.h"
#include "services/cli/console/files.h"
#include "services/cli/console/model_file.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"

namespace slicefarm::lab {

absl::StatusOr<milling::TriangleMesh> ReadTriangles(const std::string& path) {
  const auto file = cli::ReadModelFile(path);
  if (!file.ok()) return file.status();
  const auto raw = slicing::ReadMesh(file->bytes, file->format, limits::kMaxMeshCoordinateMm, {});
  if (!raw.ok()) return cli::InFile(path, raw.status());
  return milling::TriangleMesh{raw->positions, raw->triangles};
}

}  // namespace slicefarm::lab
