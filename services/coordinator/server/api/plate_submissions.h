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

/// Returns the request ids of all plates that a call with this request_id may have created. No
/// client's own id can be among them.
std::vector<std::string> PlateRequestIds(const std::string& request_id);

/// Keeps only the part of a plate's spec that differs between plates: its request and bed, and the
/// names and numbers of copies of its objects.
void KeepWhatIsOnThePlate(v1::JobSpec& spec);

/// Returns a digest of the specs. It is equal for equal specs in the same order.
std::string SpecDigest(const v1::CreatePlatesRequest& request);

/// One of the jobs that a call creates.
struct Plate {
  int request = 0;  ///< index of the request
  Submission submission;
};

/// Requests of a call, arranged on beds one after another. Their total size is limited
/// (limits::kMaxBatchJobs, limits::kMaxPlatesBytes) before a submission is copied for each bed.
class PlateRequests {
 public:
  explicit PlateRequests(std::string request_id) : request_id_(std::move(request_id)) {}

  /// Arranges the copies of the next request on beds. Errors: errors of JobIntake::Check,
  /// BlobStores and ArrangingStage; REQUEST_TOO_LARGE if a call would create too many plates or too
  /// many bytes.
  absl::Status Add(const StageCall& call, Submission submission, const PlatesBackend& backend);

  /// Returns a submission for each bed. All its copies have positions, and it has a request_id of
  /// its own. Errors: errors of reading the specs.
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
