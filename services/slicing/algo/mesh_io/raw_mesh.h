#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/geometry/vector.h"
#include "common/model/limits.h"

namespace slicefarm::slicing {

/// Largest number of vertices of a file, used by its triangles or not.
constexpr int64_t kMaxVertices = 3 * limits::kMaxTriangles;

/// Triangles as read from a file. The corners are valid indices into `positions`. Every coordinate
/// is finite and within the limit given to the reader.
struct RawMesh {
  std::vector<Vector3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
};

}  // namespace slicefarm::slicing
