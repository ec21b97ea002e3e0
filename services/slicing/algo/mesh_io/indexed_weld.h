#pragma once

#include <algorithm>
#include <utility>

#include "common/geometry/vector.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"
#include "services/slicing/algo/mesh_io/weld.h"

namespace slicefarm::slicing {

/// Returns the same triangles with equal positions merged and unused positions removed. The order
/// of positions is the order of their first use. REQUIRES: valid indices.
inline RawMesh Welded(const RawMesh& mesh) {
  constexpr uint32_t kNew = UINT32_MAX;
  Welder<Vector3> welder(std::min(mesh.positions.size(), 3 * mesh.triangles.size()));
  std::vector<uint32_t> numbers(mesh.positions.size(), kNew);
  const auto number = [&](uint32_t corner) {
    const Vector3& p = mesh.positions[corner];
    // Adding zero gives -0 and +0 the same bits.
    if (numbers[corner] == kNew)
      numbers[corner] = welder.Add({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0});
    return numbers[corner];
  };
  RawMesh welded;
  welded.triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const uint32_t a = number(t[0]), b = number(t[1]), c = number(t[2]);
    welded.triangles.push_back({a, b, c});
  }
  welded.positions = std::move(welder).TakePoints();
  return welded;
}

}  // namespace slicefarm::slicing
