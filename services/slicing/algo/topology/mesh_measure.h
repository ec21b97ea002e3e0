#pragma once

#include <array>
#include <cstdint>

#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// Bounding box of a mesh in space; min > max for a mesh without vertices.
struct Extent {
  Vertex min{INT64_MAX, INT64_MAX, INT64_MAX};
  Vertex max{INT64_MIN, INT64_MIN, INT64_MIN};

  /// Extends this box so that it contains `other`.
  void Add(const Extent& other);
};
/// Returns the bounding box of a mesh.
Extent ExtentOf(const IndexedMesh& mesh);

/// Returns six times the volume in nm^3 between a face and the plane z = 0; negative if the face
/// points down. Exact for coordinates within 32 bits, so a sum over a mesh does not depend on the
/// order of the faces.
__int128 SixVolumes(const IndexedMesh& mesh, const std::array<uint32_t, 3>& triangle);

/// Returns the signed volume of all faces together. Cost: O(n).
double VolumeMm3(const IndexedMesh& mesh);

/// Returns true if the corners are on one line. Exact.
bool HasNoArea(const IndexedMesh& mesh, const std::array<uint32_t, 3>& triangle);

}  // namespace slicefarm::slicing
