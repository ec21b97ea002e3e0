#pragma once

#include <array>
#include <cstdint>

#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// Extent of a mesh; min > max for a mesh without vertices.
struct Extent {
  Vertex min{INT64_MAX, INT64_MAX, INT64_MAX};
  Vertex max{INT64_MIN, INT64_MIN, INT64_MIN};

  void Add(const Extent& other);
};
Extent ExtentOf(const IndexedMesh& mesh);

/// Six times the volume in nm^3 between a face and the plane z = 0, negative for a face that looks
/// down. Exact for coordinates within 32 bits, so a sum over a mesh does not depend on its order.
__int128 SixVolumes(const IndexedMesh& mesh, const std::array<uint32_t, 3>& triangle);

/// Signed volume of all faces together. Cost: O(n).
double VolumeMm3(const IndexedMesh& mesh);

/// Whether the corners lie on one line. Exact.
bool HasNoArea(const IndexedMesh& mesh, const std::array<uint32_t, 3>& triangle);

}  // namespace slicefarm::slicing
