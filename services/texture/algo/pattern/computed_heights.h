#pragma once

#include "absl/status/statusor.h"
#include "services/texture/algo/pattern/height_grid.h"
#include "services/texture/algo/pattern/texture_spec.h"

namespace slicefarm::texture {

inline constexpr int64_t kMaxHeightNodes = 4'000'000;

/// A computed texture as heights from 0 to its height, which repeat without seams. A steep flank
/// takes a cell of the grid at least.
///
/// Same bits on each machine. Errors: REQUEST_TOO_LARGE past kMaxHeightNodes. Cost: O(1) a node, of
/// letters O(strokes).
absl::StatusOr<HeightGrid> ComputedHeights(const TextureSpec& spec);

}  // namespace slicefarm::texture
