#include "services/cli/models/mill_mesh.h"

#include "common/model/limits.h"
#include "services/cli/files.h"
#include "services/cli/models/given_models.h"
#include "services/slicing/algo/mesh_io/mesh_reader.h"

namespace slicefarm::cli {

absl::StatusOr<milling::TriangleMesh> ReadTriangles(const std::string& path) {
  const auto file = ReadModelFile(path);
  if (!file.ok()) return file.status();
  const auto raw = slicing::ReadMesh(file->bytes, file->format, limits::kMaxMeshCoordinateMm, {});
  if (!raw.ok()) return InFile(path, raw.status());
  milling::TriangleMesh mesh;
  mesh.points_mm.reserve(raw->positions.size());
  for (const slicing::Position& p : raw->positions) mesh.points_mm.push_back({p.x, p.y, p.z});
  mesh.triangles = raw->triangles;
  return mesh;
}

}  // namespace slicefarm::cli
