#pragma once

#include <span>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"
#include "services/beading/algo/arachne/neighbour_outlines.h"

namespace slicefarm {
struct BeadingOptions;
}  // namespace slicefarm

namespace slicefarm::beading {

/// A section and the layers of its object around it.
struct SectionPlace {
  const ObjectSection& section;
  bool on_bed = false;                  ///< beads are as wide as the first layer's settings say
  const NeighbourOutlines& neighbours;  ///< of its object
  size_t index = 0;                     ///< its own layer among them
};

struct SectionResult {
  WalledSection walled;
  int32_t plain_islands = 0;  ///< that fell back to walls of constant width
};

/// The walls of one section. Regions of the same role, tool and wall class are walled as one, so
/// walls run on where only the infill's settings change; what is left for the infill is then parted
/// by region. `regions`: by row of the job's tables. Errors: see local_beading_stage.h.
absl::StatusOr<SectionResult> WallSection(const SectionPlace& place,
                                          std::span<const BeadingOptions> regions,
                                          const CancelToken& cancel);

}  // namespace slicefarm::beading
