#include "services/cli/models/mill_mesh.h"

#include "common/model/limits.h"
#include "services/cli/files.h"
#include "services/cli/models/given_models.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"

namespace slicefarm::cli {

absl::StatusOr<milling::TriangleMesh> ReadTriangles(const std::string& path) {
  const auto file = ReadModelFile(path);
  if (!file.ok()) return file.status();
  const auto raw = slicing::ReadMesh(file->bytes, file->format, limits::kMaxMeshCoordinateMm, {});
  if (!raw.ok()) return InFile(path, raw.status());
  return milling::TriangleMesh{raw->positions, raw->triangles};
}

}  // namespace slicefarm::cli
