#pragma once

#include <cstdint>
#include <span>

#include "common/model/job_facts.h"
#include "common/model/layers/layer.h"

namespace slicefarm::motion {

/// Position of a pass's layer in the print. With one pass, layers are counted as the job's layers.
/// With a pass for each copy, they are counted as the copy's.
struct LayerPlace {
  int32_t pass = 0;
  int32_t index = 0;   ///< index in its pass; 0 is on the bed, and the layers of a raft are counted
  int32_t number = 0;  ///< planned number in the whole print
  Coord print_z_nm = 0;
  Coord top_nm = 0;  ///< height of the print so far
};

/// Returns the position of a layer. `visits`: visits of the pass, may be empty.
LayerPlace PlaceOf(const OrderedLayer& layer, std::span<const BlockVisit> visits,
                   const JobFacts& facts);

}  // namespace slicefarm::motion
