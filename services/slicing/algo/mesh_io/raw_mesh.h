#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/model/limits.h"

namespace slicefarm::slicing {

/// A point in the units of the file.
struct Position {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(const Position&, const Position&) = default;
};

/// Of a file, used by its triangles or not.
constexpr int64_t kMaxVertices = 3 * limits::kMaxTriangles;

/// Triangles as a file gives them: corners index `positions`, every index is valid, every
/// coordinate finite and within the limit given to the reader.
struct RawMesh {
  std::vector<Position> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
};

}  // namespace slicefarm::slicing
