#include "services/lab/surface_mesh.h"

#include "common/model/limits.h"
#include "services/cli/console/files.h"
#include "services/cli/console/model_file.h"
#include "services/slicing/algo/mesh_io/obj_reader.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"

namespace slicefarm::lab {
namespace {

texture::SurfaceMesh SurfaceOf(const slicing::RawMesh& raw) {
  texture::SurfaceMesh mesh;
  mesh.points_mm = raw.positions;
  for (const auto& [a, b, c] : raw.triangles)
    mesh.triangles.push_back(
        {static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(c)});
  return mesh;
}

}  // namespace

absl::StatusOr<texture::SurfaceMesh> ReadSurface(const std::string& path) {
  const auto file = cli::ReadModelFile(path);
  if (!file.ok()) return file.status();
  const MeshFormat format =
      file->format == MeshFormat::kUnknown ? slicing::DetectFormat(file->bytes) : file->format;
  const auto raw = format == MeshFormat::kObj
                       ? slicing::ReadObjAsNumbered(file->bytes, limits::kMaxMeshCoordinateMm, {})
                       : slicing::ReadMesh(file->bytes, format, limits::kMaxMeshCoordinateMm, {});
  if (!raw.ok()) return cli::InFile(path, raw.status());
  return SurfaceOf(*raw);
}

}  // namespace slicefarm::lab
