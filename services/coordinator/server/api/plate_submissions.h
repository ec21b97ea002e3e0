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

/// Objects that are needed to arrange plates. All of them must outlive the call.
struct PlatesBackend {
  JobIntake& intake;
  BlobStores& blobs;
  const ArrangingStage& arranging;
  MemoryBudget& memory;
};

/// Checks a CreatePlates call: its request_id must be usable, and its requests must not set fields
/// that are common to all plates.
absl::Status CheckPlates(const v1::CreatePlatesRequest& request);

/// Returns the request ids of all plates that a call with this request_id may have created. Clients
/// cannot send ids of this form.
std::vector<std::string> PlateRequestIds(const std::string& request_id);

/// Removes the parts of a spec that are the same on all plates of a request. Keeps the plate's
/// request and bed, and the names and numbers of copies of its objects.
void KeepWhatIsOnThePlate(v1::JobSpec& spec);

/// Returns a digest of the specs of the call. Calls with equal specs in the same order have equal
/// digests.
std::string SpecDigest(const v1::CreatePlatesRequest& request);

/// Job of a CreatePlates call: one bed of a request.
struct Plate {
  int request = 0;  ///< index of the request in the call
  Submission submission;
};

/// Requests of a CreatePlates call, each arranged on one or more beds. The number of plates and the
/// size of their specs are limited (limits::kMaxBatchJobs, limits::kMaxPlatesBytes); this is
/// checked before a submission is copied for each bed.
class PlateRequests {
 public:
  explicit PlateRequests(std::string request_id) : request_id_(std::move(request_id)) {}

  /// Arranges the copies of the next request on beds. Errors: see JobIntake::Check, BlobStores and
  /// ArrangingStage; REQUEST_TOO_LARGE if the call would create too many plates or too many bytes.
  absl::Status Add(const StageCall& call, Submission submission, const PlatesBackend& backend);

  /// Returns a submission for each bed, with a request_id of its own and with the positions of all
  /// copies. Errors: errors of FromProto (jobs_wire.h) for the spec of a plate.
  absl::StatusOr<std::vector<Plate>> Plates() &&;

 private:
  struct Arranged {
    Submission submission;
    std::vector<std::vector<SceneObject>> beds;
  };

  const std::string request_id_;
  int64_t plates_ = 0;
  int64_t bytes_ = 0;  ///< size of all plates' specs
  std::vector<Arranged> requests_;
};

}  // namespace slicefarm::coordinator
