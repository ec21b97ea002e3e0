#pragma once

#include <cstdint>
#include <span>

#include "common/model/job_facts.h"
#include "common/model/layers/layer.h"

namespace slicefarm::motion {

/// Position of a pass's layer in the print. A job with one pass counts its layers. If each copy is
/// a pass of its own, the layers of each copy are counted.
struct LayerContext {
  int32_t pass = 0;
  int32_t index = 0;   ///< index in its pass, from 0 on the bed; layers of a raft are counted too
  int32_t number = 0;  ///< planned number in the whole print
  Coord print_z_nm = 0;
  Coord top_nm = 0;  ///< height of the highest layer printed so far, including this one
};

/// Returns the position of a layer. `visits`: the layer's visits in the pass; may be empty.
LayerContext ContextOf(const OrderedLayer& layer, std::span<const BlockVisit> visits,
                       const JobFacts& facts);

}  // namespace slicefarm::motion
