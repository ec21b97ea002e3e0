#pragma once

#include <string>

#include "common/model/milling/milling_options.h"
#include "common/model/scene/mesh.h"

namespace slicefarm {

/// What is milled and how. Meshes are in the program's coordinates.
struct MillInput {
  IndexedMesh part;
  IndexedMesh stock;  ///< no triangles: a box around the part
  MillSettings settings;
  /// SHA-256 of both meshes (DigestOf): who prepared them once need not do it again.
  std::string digest;
};

/// SHA-256, as it is stored, of part and stock as little-endian numbers. Cost: O(bytes).
std::string DigestOf(const IndexedMesh& part, const IndexedMesh& stock);

}  // namespace slicefarm
