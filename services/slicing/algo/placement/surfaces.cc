#include "services/slicing/algo/placement/surfaces.h"

#include <iterator>
#include <utility>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/placement/placed_object.h"

namespace slicefarm::slicing {
namespace {

absl::Status CheckOnePart(const ObjectInput& object) {
  if (object.parts.size() == 1 && object.copies.size() == 1) return absl::OkStatus();
  return Malformed(absl::StrCat("object \"", absl::Utf8SafeCEscape(object.name),
                                "\" must have one part and one copy to be a surface"));
}

absl::Status CheckSurfaceSize(const RawMesh& mesh) {
  if (std::ssize(mesh.triangles) > limits::kMaxSurfaceTriangles)
    return LimitError(Reason::kMeshTooLarge, "triangles of a surface", limits::kMaxSurfaceTriangles,
                      std::ssize(mesh.triangles));
  if (std::ssize(mesh.positions) > limits::kMaxSurfacePoints)
    return LimitError(Reason::kMeshTooLarge, "points of a surface", limits::kMaxSurfacePoints,
                      std::ssize(mesh.positions));
  return absl::OkStatus();
}

absl::Status CheckWithin(const SurfaceMesh& mesh, const std::string& object) {
  for (const Eigen::Vector3d& p : mesh.points_mm) {
    const double farthest = p.cwiseAbs().maxCoeff();
    if (farthest <= limits::kMaxMeshCoordinateMm) continue;
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kMeshTooLarge,
        absl::StrCat("object \"", absl::Utf8SafeCEscape(object), "\", transformed, has a point ",
                     farthest, " mm from the origin; ", limits::kMaxMeshCoordinateMm,
                     " mm are allowed"));
  }
  return absl::OkStatus();
}

/// Returns the transformed mesh. The identity is not applied, so that coordinates keep all bits.
SurfaceMesh Transformed(const RawMesh& raw, const Transform& transform) {
  SurfaceMesh mesh;
  mesh.points_mm.reserve(raw.positions.size());
  for (const Vector3& p : raw.positions) {
    const Eigen::Vector3d place(p.x(), p.y(), p.z());
    mesh.points_mm.push_back(transform == Transform::Identity()
                                 ? place
                                 : transform.leftCols<3>() * place + transform.col(3));
  }
  mesh.triangles.reserve(raw.triangles.size());
  for (const auto& [a, b, c] : raw.triangles)
    mesh.triangles.push_back(
        {static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(c)});
  return mesh;
}

}  // namespace

absl::StatusOr<std::vector<SurfaceMesh>> SurfacesOf(SliceInput input, const MeshSource& source,
                                                    const CancelToken& cancel) {
  PartMeshes meshes(std::move(input.files), input.objects, source, cancel, ReadDepth::kNumbered);
  std::vector<SurfaceMesh> surfaces;
  for (const ObjectInput& object : input.objects) {
    if (absl::Status one = CheckOnePart(object); !one.ok()) return one;
    const PartInput& part = object.parts.front();
    const auto raw = meshes.Take(part.mesh);
    if (!raw.ok()) return raw.status();
    if (absl::Status fits = CheckSurfaceSize(*raw); !fits.ok()) return fits;
    surfaces.push_back(Transformed(*raw, Combined(object.to_plate, part.to_object)));
    if (absl::Status near = CheckWithin(surfaces.back(), object.name); !near.ok()) return near;
  }
  return surfaces;
}

}  // namespace slicefarm::slicing
