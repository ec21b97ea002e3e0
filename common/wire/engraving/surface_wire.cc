#include "common/wire/engraving/surface_wire.h"

#include <cmath>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

absl::Status ToProto(const SurfaceMesh& mesh, v1::SurfaceMesh* proto) {
  proto->mutable_xyz_mm()->Reserve(static_cast<int>(3 * mesh.points_mm.size()));
  for (const Eigen::Vector3d& p : mesh.points_mm)
    for (const double c : {p.x(), p.y(), p.z()}) proto->add_xyz_mm(c);
  proto->mutable_corners()->Reserve(static_cast<int>(3 * mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles)
    for (const int32_t corner : triangle) proto->add_corners(corner);
  return absl::OkStatus();
}

absl::StatusOr<SurfaceMesh> FromProto(const v1::SurfaceMesh& proto) {
  if (proto.xyz_mm_size() % 3 != 0) return Malformed("xyz_mm", "not three numbers a point");
  if (proto.corners_size() % 3 != 0) return Malformed("corners", "not three a triangle");
  const int points = proto.xyz_mm_size() / 3, triangles = proto.corners_size() / 3;
  if (triangles > limits::kMaxSurfaceTriangles)
    return LimitError(Reason::kMeshTooLarge, "triangles of a surface", limits::kMaxSurfaceTriangles,
                      triangles);
  for (const double c : proto.xyz_mm())
    if (!(std::abs(c) <= limits::kMaxMeshCoordinateMm))
      return Malformed("xyz_mm", "is farther from the origin than a mesh may be");
  for (const int32_t corner : proto.corners())
    if (corner < 0 || corner >= points) return Malformed("corners", "no point is there");
  SurfaceMesh mesh;
  mesh.points_mm.reserve(static_cast<size_t>(points));
  for (int i = 0; i < 3 * points; i += 3)
    mesh.points_mm.push_back({proto.xyz_mm(i), proto.xyz_mm(i + 1), proto.xyz_mm(i + 2)});
  mesh.triangles.reserve(static_cast<size_t>(triangles));
  for (int i = 0; i < 3 * triangles; i += 3)
    mesh.triangles.push_back({proto.corners(i), proto.corners(i + 1), proto.corners(i + 2)});
  return mesh;
}

}  // namespace slicefarm
