#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/stage/stage_call.h"

namespace slicefarm {

struct OrderingJob;

/// Stage that orders the paths of each layer.
class OrderingStage {
 public:
  virtual ~OrderingStage() = default;
  /// Returns the layers with their paths in the order of printing. `plans`: one per layer.
  virtual absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall& call,
                                                          std::vector<FilledLayer> layers,
                                                          std::span<const LayerPlan> plans,
                                                          const Shared<OrderingJob>& job) const = 0;
};

}  // namespace slicefarm
