#pragma once

#include <span>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"
#include "services/beading/algo/arachne/neighbour_outlines.h"
#include "services/beading/algo/island_memo.h"

namespace slicefarm {
struct BeadingOptions;
}  // namespace slicefarm

namespace slicefarm::beading {

/// Section of a stack, and the outlines of the layers around it. The struct refers to `section` and
/// `neighbours`; it does not own them.
struct SectionContext {
  const ObjectSection& section;
  bool on_bed = false;  ///< true in the plate's first layer, which has its own bead widths
  const NeighbourOutlines& neighbours;  ///< outlines of the section's stack
  size_t index = 0;                     ///< index of the section's layer in `neighbours`
  IslandMemo* memo = nullptr;           ///< islands of this layer and the one before; may be null
};

/// Result of WallSection.
struct SectionResult {
  WalledSection walled;
  /// Number of islands for which variable walls are impossible, so they got constant-width walls.
  int32_t plain_islands = 0;
};

/// Makes the walls of one section. Regions with the same role, tool and wall class share their
/// walls, so these walls continue where only the infill's settings change. The area left for the
/// infill is then divided by region.
///
/// `regions`: options, indexed by Region::settings. Errors: see local_beading_stage.h.
absl::StatusOr<SectionResult> WallSection(const SectionContext& context,
                                          std::span<const BeadingOptions> regions,
                                          const CancelToken& cancel);

}  // namespace slicefarm::beading
