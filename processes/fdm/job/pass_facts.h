#pragma once

#include <span>
#include <vector>

#include "common/model/job_facts.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// What is known of the passes before any layer is programmed. What stands on the plate alone, such
/// as a raft, belongs to the first pass.
struct PassPlan {
  std::vector<PassFacts> passes;  ///< by pass; none if there is one
  int32_t layer_count = 0;        ///< of all passes
};

/// Cost: O(layers + copies). REQUIRES: each pass is that of some copy.
PassPlan PassesOf(std::span<const SlicedLayer> layers, std::span<const Copy> copies);

}  // namespace slicefarm::coordinator
