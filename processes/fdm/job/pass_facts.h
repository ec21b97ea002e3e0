#pragma once

#include <span>
#include <vector>

#include "common/model/job_facts.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// Facts about the passes that are known before any layer is programmed. A pass prints its copies
/// layer by layer before the next pass begins (Copy::pass). Stacks of the plate, such as a raft,
/// belong to the first pass.
struct PassPlan {
  std::vector<PassFacts> passes;  ///< one per pass; empty if there is only one pass
  int32_t layer_count = 0;        ///< total number of layers of all passes
};

/// Returns the facts about the passes. Cost: O(layers + copies). REQUIRES: each pass has a copy.
PassPlan PassesOf(std::span<const SlicedLayer> layers, std::span<const Copy> copies);

}  // namespace slicefarm::coordinator
