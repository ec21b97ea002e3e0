#pragma once

#include <cstdint>
#include <span>

#include "common/model/job_facts.h"
#include "common/model/layers/layer.h"

namespace slicefarm::motion {

/// Where a layer of a pass stands in the print. If there is one pass, these are the job's layers; if
/// each copy has its own, the copy's.
struct LayerPlace {
  int32_t pass = 0;
  int32_t index = 0;   ///< in its pass: 0 lies on the bed, a raft's layers are counted
  int32_t number = 0;  ///< in the whole print, as planned
  Coord print_z_nm = 0;
  Coord top_nm = 0;  ///< how high the print reaches by then
};

/// `visits`: those of the pass, may be empty.
LayerPlace PlaceOf(const OrderedLayer& layer, std::span<const BlockVisit> visits,
                   const JobFacts& facts);

}  // namespace slicefarm::motion
