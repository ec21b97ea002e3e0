#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/stage/plates.h"
#include "services/coordinator/server/api/job_intake.h"
#include "services/coordinator/server/execution/byte_budget.h"

namespace slicefarm::coordinator {

/// What putting on plates takes. Everything outlives the call.
struct PlatesBackend {
  JobIntake& intake;
  BlobStores& blobs;
  const ArrangingStage& arranging;
  ByteBudget& mesh_memory;
};

/// The submission as one for each bed that its copies take, with places for all. Errors: those of
/// JobIntake::Check, BlobStores and ArrangingStage.
absl::StatusOr<std::vector<Submission>> PlatesOf(const StageCall& call,
                                                 const Submission& submission,
                                                 const PlatesBackend& backend);

}  // namespace slicefarm::coordinator
