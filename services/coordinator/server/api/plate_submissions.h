#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/stage/memory_budget.h"
#include "common/stage/plates.h"
#include "services/coordinator/server/api/job_intake.h"

namespace slicefarm::coordinator {

/// What putting on plates takes. Everything outlives the call.
struct PlatesBackend {
  JobIntake& intake;
  BlobStores& blobs;
  const ArrangingStage& arranging;
  MemoryBudget& memory;
};

/// How many plates a call may make.
struct PlateRoom {
  int64_t made = 0;  ///< by the requests before
  int64_t most = 0;
};

/// The submission as one for each bed that its copies take, with places for all. Beds are counted
/// before a submission is copied for each. Errors: those of JobIntake::Check, BlobStores and
/// ArrangingStage; REQUEST_TOO_LARGE for more plates than there is room for.
absl::StatusOr<std::vector<Submission>> PlatesOf(const StageCall& call,
                                                 const Submission& submission,
                                                 const PlateRoom& room,
                                                 const PlatesBackend& backend);

}  // namespace slicefarm::coordinator
