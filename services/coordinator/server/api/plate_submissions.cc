#include "services/coordinator/server/api/plate_submissions.h"

#include <utility>

#include "common/base/error.h"
#include "common/wire/scene_wire.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/api/jobs_wire.h"
#include "services/coordinator/server/execution/job_meshes.h"

namespace slicefarm::coordinator {
namespace {

/// The scene's objects on the beds that they take.
absl::StatusOr<std::vector<std::vector<SceneObject>>> Arranged(const StageCall& call,
                                                               const std::string& tenant,
                                                               const ResolvedJob& job,
                                                               const PlatesBackend& backend) {
  const auto blobs = backend.blobs.Of(tenant);
  if (!blobs.ok()) return blobs.status();
  const auto room = RoomForMeshes(call, job, **blobs, backend.memory);
  if (!room.ok()) return room.status();
  auto input = LoadMeshes(job, **blobs);
  if (!input.ok()) return input.status();
  const std::vector<SceneObject>& objects = job.request.scene.objects;
  input->objects = ObjectsToPlace(objects);
  const auto places =
      backend.arranging.PutOnPlates(call, *std::move(input), job.plate.settings.slicing);
  if (!places.ok()) return places.status();
  return OnPlates(objects, *places);
}

/// The submission with these objects in place of its own. What a plate has no use for, such as
/// other plates' meshes, does not belong to its job.
absl::StatusOr<Submission> WithObjects(const Submission& submission,
                                       const std::vector<SceneObject>& objects) {
  v1::JobSpec spec;
  spec.ParseFromString(submission.spec);
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

absl::StatusOr<std::vector<Submission>> PlatesOf(const StageCall& call,
                                                 const Submission& submission,
                                                 const PlateRoom& room,
                                                 const PlatesBackend& backend) {
  const auto resolved = backend.intake.Check(submission);
  if (!resolved.ok()) return resolved.status();
  const auto beds = Arranged(call, submission.tenant, *resolved, backend);
  if (!beds.ok()) return beds.status();
  if (const int64_t count = room.made + std::ssize(*beds); count > room.most)
    return LimitError(Reason::kRequestTooLarge, "plates", room.most, count);
  std::vector<Submission> plates;
  for (const std::vector<SceneObject>& objects : *beds) {
    auto plate = WithObjects(submission, objects);
    if (!plate.ok()) return plate.status();
    plates.push_back(*std::move(plate));
  }
  return plates;
}

}  // namespace slicefarm::coordinator
