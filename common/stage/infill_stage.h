#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/stage/neighbourhood.h"
#include "common/stage/stage_call.h"

namespace slicefarm {

struct InfillOptions;

/// Infill of each region, by row of the job's regions. All calls of a job share it.
using InfillTable = std::vector<InfillOptions>;

class InfillStage {
 public:
  virtual ~InfillStage() = default;
  /// `walled` and `plans`: of the layers of neighbourhood.range; of a plan, its `infill`.
  virtual absl::StatusOr<std::vector<FilledLayer>> Fill(
      const StageCall& call, std::vector<WalledLayer> walled, const Neighbourhood& neighbourhood,
      std::span<const LayerPlan> plans, const Shared<InfillTable>& regions) const = 0;
};

}  // namespace slicefarm
