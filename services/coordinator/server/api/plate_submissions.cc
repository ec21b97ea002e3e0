#include "services/coordinator/server/api/plate_submissions.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/model/limits.h"
#include "common/wire/scene_wire.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/execution/job_meshes.h"
#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

/// Returns the request id of a plate, counted from 0. Returns an empty id if the call has none. The
/// id contains a control character, which no client's id may contain.
std::string PlateRequestId(const std::string& request_id, size_t plate) {
  return request_id.empty() ? "" : fmt::format("{}\x1f{}", request_id, plate + 1);
}

/// Arranges the scene's objects on beds. Returns the objects of each bed.
absl::StatusOr<std::vector<std::vector<SceneObject>>> OnBeds(const StageCall& call,
                                                             const std::string& tenant,
                                                             const ResolvedJob& job,
                                                             const PlatesBackend& backend) {
  const auto blobs = backend.blobs.Of(tenant);
  if (!blobs.ok()) return blobs.status();
  const auto reserved = ReserveMeshMemory(call, job, **blobs, backend.memory);
  if (!reserved.ok()) return reserved.status();
  auto input = LoadMeshes(job, **blobs);
  if (!input.ok()) return input.status();
  const std::vector<SceneObject>& objects = job.request.scene.objects;
  input->objects = ObjectsToArrange(objects);
  const auto positions =
      backend.arranging.PutOnPlates(call, *std::move(input), job.plate.settings.slicing);
  if (!positions.ok()) return positions.status();
  return OnPlates(objects, *positions);
}

/// Returns the submission with these objects instead of its own. Omits data that the plate does not
/// need, such as meshes of other plates.
absl::StatusOr<Submission> WithObjects(const Submission& submission,
                                       const std::vector<SceneObject>& objects, size_t of_request,
                                       size_t bed) {
  v1::JobSpec spec;
  spec.ParseFromString(submission.spec);
  spec.mutable_plate()->set_request(static_cast<int32_t>(of_request));
  spec.mutable_plate()->set_bed(static_cast<int32_t>(bed));
  spec.clear_objects();
  for (const SceneObject& object : objects)
    ToProto(object, submission.request.scene.meshes, spec.add_objects());
  auto request = FromProto(spec);
  if (!request.ok()) return Within("spec", request.status());
  Submission plate = submission;
  plate.spec = SpecBytes(spec);
  plate.request = *std::move(request);
  return plate;
}

}  // namespace

absl::Status CheckPlates(const v1::CreatePlatesRequest& request) {
  if (absl::Status ok = CheckRequestId(request.request_id()); !ok.ok()) return ok;
  if (request.requests().empty()) return Malformed("requests", "is empty: give at least one");
  if (request.requests_size() > limits::kMaxBatchJobs)
    return LimitError(Reason::kRequestTooLarge, "requests", limits::kMaxBatchJobs,
                      request.requests_size());
  for (int i = 0; i < request.requests_size(); ++i) {
    const v1::CreateJobRequest& each = request.requests(i);
    if (!each.request_id().empty() || each.validate_only())
      return Within("requests", i,
                    Malformed("request_id, validate_only", "must not be set for a single plate"));
    if (each.advise_orientations() && !request.validate_only())
      return Within("requests", i,
                    Malformed("advise_orientations", "works only with validate_only"));
  }
  return absl::OkStatus();
}

std::vector<std::string> PlateRequestIds(const std::string& request_id) {
  std::vector<std::string> ids;
  for (size_t plate = 0; plate < limits::kMaxBatchJobs; ++plate)
    ids.push_back(PlateRequestId(request_id, plate));
  return ids;
}

void KeepWhatIsOnThePlate(v1::JobSpec& spec) {
  v1::JobSpec kept;
  if (spec.has_plate()) *kept.mutable_plate() = spec.plate();
  for (const v1::Object& object : spec.objects()) {
    v1::Object& named = *kept.add_objects();
    named.set_name(object.name());
    named.set_copies(std::max(object.instances_size(), std::max(object.copies(), 1)));
  }
  spec = std::move(kept);
}

std::string SpecDigest(const v1::CreatePlatesRequest& request) {
  std::string digests;
  for (const v1::CreateJobRequest& each : request.requests())
    digests += Sha256Hex(SpecBytes(each.spec()));
  return Sha256Hex(digests);
}

absl::Status PlateRequests::Add(const StageCall& call, Submission submission,
                                const PlatesBackend& backend) {
  const auto resolved = backend.intake.Check(submission, call.cancel);
  if (!resolved.ok()) return resolved.status();
  auto beds = OnBeds(call, submission.tenant, **resolved, backend);
  if (!beds.ok()) return beds.status();
  plates_ += std::ssize(*beds);
  if (plates_ > limits::kMaxBatchJobs)
    return LimitError(Reason::kRequestTooLarge, "plates", limits::kMaxBatchJobs, plates_);
  bytes_ += std::ssize(*beds) * std::ssize(submission.spec);
  if (bytes_ > limits::kMaxPlatesBytes)
    return LimitError(Reason::kRequestTooLarge, "bytes of all plates' specs",
                      limits::kMaxPlatesBytes, bytes_);
  requests_.push_back({std::move(submission), *std::move(beds)});
  return absl::OkStatus();
}

absl::StatusOr<std::vector<Plate>> PlateRequests::Plates() && {
  std::vector<Plate> plates;
  for (size_t i = 0; i < requests_.size(); ++i) {
    const auto& beds = requests_[i].beds;
    for (size_t bed = 0; bed < beds.size(); ++bed) {
      auto plate = WithObjects(requests_[i].submission, beds[bed], i, bed);
      if (!plate.ok()) return Within("requests", static_cast<int>(i), plate.status());
      plate->request_id = PlateRequestId(request_id_, plates.size());
      plates.push_back({static_cast<int>(i), *std::move(plate)});
    }
  }
  return plates;
}

}  // namespace slicefarm::coordinator
