#include "services/slicing/algo/mesh_io/mesh_part.h"

#include <cstddef>
#include <limits>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::slicing {
namespace {

absl::Status NotThere() {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "a part refers to triangles that are not in its mesh");
}

RawMesh Compact(const RawMesh& mesh, size_t first, size_t count) {
  constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
  std::vector<uint32_t> place(mesh.positions.size(), kNone);
  for (size_t i = first; i < first + count; ++i)
    for (const uint32_t corner : mesh.triangles[i]) place[corner] = 0;
  RawMesh part;
  for (size_t i = 0; i < place.size(); ++i) {
    if (place[i] == kNone) continue;
    place[i] = static_cast<uint32_t>(part.positions.size());
    part.positions.push_back(mesh.positions[i]);
  }
  part.triangles.reserve(count);
  for (size_t i = first; i < first + count; ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    part.triangles.push_back({place[a], place[b], place[c]});
  }
  return part;
}

}  // namespace

absl::StatusOr<RawMesh> MeshPart(const RawMesh& mesh, const MeshRef& ref) {
  const int64_t all = std::ssize(mesh.triangles);
  if (ref.first_triangle < 0 || ref.first_triangle > all || ref.triangle_count < -1 ||
      ref.triangle_count > all - ref.first_triangle)
    return NotThere();
  const int64_t count = ref.triangle_count < 0 ? all - ref.first_triangle : ref.triangle_count;
  if (count == 0)
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                     "the mesh of a part has no triangles");
  if (count == all) return mesh;
  return Compact(mesh, static_cast<size_t>(ref.first_triangle), static_cast<size_t>(count));
}

}  // namespace slicefarm::slicing
