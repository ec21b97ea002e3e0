#pragma once

#include "absl/status/statusor.h"
#include "services/texture/algo/pattern/height_grid.h"
#include "services/texture/algo/pattern/texture_spec.h"

namespace slicefarm::texture {

/// Largest number of nodes of a HeightGrid.
inline constexpr int64_t kMaxHeightNodes = 4'000'000;

/// Returns a computed texture as a height grid. Heights are between 0 and the texture's height, and
/// repeat without seams. A steep flank is at least one cell of the grid wide.
///
/// The result has the same bits on each machine. Errors: REQUEST_TOO_LARGE above kMaxHeightNodes.
/// Cost: O(1) per node; for letters O(strokes) per node.
absl::StatusOr<HeightGrid> ComputedHeights(const TextureSpec& spec);

}  // namespace slicefarm::texture
