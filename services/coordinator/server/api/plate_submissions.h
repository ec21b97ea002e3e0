#pragma once

#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/limits.h"
#include "common/stage/memory_budget.h"
#include "common/stage/plates.h"
#include "services/coordinator/server/api/job_intake.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// What putting on plates takes. Everything outlives the call.
struct PlatesBackend {
  JobIntake& intake;
  BlobStores& blobs;
  const ArrangingStage& arranging;
  MemoryBudget& memory;
};

/// Of a call that has a usable request_id, and requests without what all plates share.
absl::Status CheckPlates(const v1::CreatePlatesRequest& request);

/// Those of all plates that a call with this request_id may have made. None that a client gives is
/// among them.
std::vector<std::string> PlateRequestIds(const std::string& request_id);

/// Leaves of a plate's spec what tells it from the others: where it is from, and which objects, and
/// how many copies of each, are on it.
void KeepWhatIsOnThePlate(v1::JobSpec& spec);

/// Equal for equal specs in the same order.
std::string SpecDigest(const v1::CreatePlatesRequest& request);

/// A job of those that a call makes.
struct Plate {
  int request = 0;  ///< of which request it is
  Submission submission;
};

/// The requests of a call, put on beds one after the other. What all of them take is bounded
/// (limits::kMaxBatchJobs, limits::kMaxPlatesBytes) before a submission is copied for each bed.
class PlateRequests {
 public:
  explicit PlateRequests(std::string request_id) : request_id_(std::move(request_id)) {}

  /// Puts the copies of the next request on beds. Errors: those of JobIntake::Check, BlobStores and
  /// ArrangingStage; REQUEST_TOO_LARGE for more plates, or more bytes of them, than a call may
  /// make.
  absl::Status Add(const StageCall& call, Submission submission, const PlatesBackend& backend);

  /// A submission for each bed, with places for all copies and a request_id of its own. Errors:
  /// those of reading the specs.
  absl::StatusOr<std::vector<Plate>> Plates() &&;

 private:
  struct Arranged {
    Submission submission;
    std::vector<std::vector<SceneObject>> beds;
  };

  const std::string request_id_;
  int64_t plates_ = 0;
  int64_t bytes_ = 0;  ///< of all plates' specs
  std::vector<Arranged> requests_;
};

}  // namespace slicefarm::coordinator
