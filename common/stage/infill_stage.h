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

/// Infill options of all regions, indexed by Region::settings. All calls of a job share the table.
using InfillTable = std::vector<InfillOptions>;

/// Stage that computes the infill of each layer's islands.
class InfillStage {
 public:
  virtual ~InfillStage() = default;
  /// Returns the layers of neighbourhood.range with walls and infill. `walled` and `plans` have one
  /// entry for each of these layers. Only LayerPlan::infill is used.
  virtual absl::StatusOr<std::vector<FilledLayer>> Fill(
      const StageCall& call, std::vector<WalledLayer> walled, const Neighbourhood& neighbourhood,
      std::span<const LayerPlan> plans, const Shared<InfillTable>& regions) const = 0;
};

}  // namespace slicefarm
