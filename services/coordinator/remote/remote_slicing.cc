#include "services/coordinator/remote/remote_slicing.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "common/model/limits.h"
#include "common/stage/job_memory.h"
#include "common/wire/engraving/surface_wire.h"
#include "common/wire/placed_scene_wire.h"
#include "common/wire/slicing_wire.h"
#include "services/coordinator/remote/slice_files.h"
#include "slicefarm/v1/slicing.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

/// Calls a method that gets the files of `input`. A small file can still have the most outlines, so
/// the deadline is the deadline of the largest job.
template <typename Result, typename Prepare, typename Take = TakeModel>
absl::StatusOr<Result> AskWithFiles(const StageClient& client, const StageCall& call,
                                    const SliceInput& input, const SlicingOptions& options,
                                    Prepare prepare, const Take& take = {}) {
  return client.Ask<Result>(
      call, client.options().DeadlineFor(limits::kMaxPointsPerJob), prepare,
      [&](auto& stream) { return WriteFiles(stream, call, input, options); }, take);
}

struct SlicedAnswer {
  SlicedJob job;
  std::optional<int32_t> layer_count;  ///< empty until the summary arrives
  int64_t bytes = 0;                   ///< memory of the layers, in bytes
};

absl::Status TakeSliced(const StageCall& call, const v1::SliceResponse& response,
                        SlicedAnswer& answer) {
  if (!answer.layer_count) {
    absl::StatusOr<SlicedJob> summary = FromProto(response.summary());
    if (!summary.ok()) return summary.status();
    answer.job = *std::move(summary);
    answer.layer_count = response.summary().layer_count();
    return absl::OkStatus();
  }
  absl::Status taken = Append(FromProto(response.layer()), &answer.job.layers);
  if (!taken.ok()) return taken;
  answer.bytes += MemoryOf(answer.job.layers.back());
  return HoldMemory(call, JobMemory::Kind::kOutlines, answer.bytes);
}

absl::Status CheckSliced(const SlicedAnswer& answer) {
  if (!answer.layer_count) return Malformed("summary", "is missing");
  if (*answer.layer_count == 0 && answer.job.layers.empty()) return absl::OkStatus();
  return CheckLayersOfRange(answer.job.layers, {0, *answer.layer_count});
}

struct PlacedAnswer {
  std::optional<PlacedScene> scene;  ///< scene; without its meshes until their pieces have arrived
  std::optional<MeshReader> meshes;
};

absl::Status TakePlaced(const v1::PlaceResponse& response, PlacedAnswer& answer) {
  if (answer.scene) return answer.meshes->Add(response.piece());
  absl::StatusOr<PlacedScene> scene = FromProto(response.scene());
  if (!scene.ok()) return scene.status();
  absl::StatusOr<MeshReader> meshes = MeshReader::Begin(MeshSizesOf(response.scene()));
  if (!meshes.ok()) return meshes.status();
  answer = {*std::move(scene), *std::move(meshes)};
  return absl::OkStatus();
}

absl::Status FinishPlaced(const StageCall& call, PlacedAnswer& answer) {
  if (!answer.scene) return Malformed("scene", "is missing");
  auto whole = answer.meshes->Finish();
  if (!whole.ok()) return whole.status();
  PutMeshes(*std::move(whole), *answer.scene);
  return HoldMemory(call, JobMemory::Kind::kMeshes, MemoryOf(*answer.scene));
}

}  // namespace

absl::StatusOr<SlicedJob> RemoteSlicing::Slice(const StageCall& call, SliceInput input,
                                               const SlicingOptions& options) const {
  auto answer =
      client_.Fitting(AskWithFiles<SlicedAnswer>(
                          client_, call, input, options, &v1::Slicing::Stub::PrepareAsyncSlice,
                          [&](const v1::SliceResponse& response, SlicedAnswer& taken) {
                            return TakeSliced(call, response, taken);
                          }),
                      CheckSliced);
  if (!answer.ok()) return answer.status();
  return std::move(answer->job);
}

absl::StatusOr<std::vector<PlatePosition>> RemoteArranging::PutOnPlates(
    const StageCall& call, SliceInput input, const SlicingOptions& options) const {
  size_t copies = 0;
  for (const ObjectInput& object : input.objects) copies += object.copies.size();
  return client_.Fitting(
      AskWithFiles<std::vector<PlatePosition>>(client_, call, input, options,
                                               &v1::Slicing::Stub::PrepareAsyncPutOnPlates),
      [&](const auto& positions) {
        return positions.size() == copies ? absl::OkStatus()
                                          : Malformed("places", "are not one for each copy");
      });
}

absl::StatusOr<PlacedScene> RemotePlacing::Place(const StageCall& call, SliceInput input,
                                                 const SlicingOptions& options) const {
  auto answer =
      client_.Fitting(AskWithFiles<PlacedAnswer>(client_, call, input, options,
                                                 &v1::Slicing::Stub::PrepareAsyncPlace, TakePlaced),
                      [&](PlacedAnswer& placed) { return FinishPlaced(call, placed); });
  if (!answer.ok()) return answer.status();
  return *std::move(answer->scene);
}

absl::StatusOr<std::vector<SurfaceMesh>> RemotePlacing::ReadSurfaces(
    const StageCall& call, SliceInput input, const SlicingOptions& options) const {
  return client_.Fitting(
      AskWithFiles<std::vector<SurfaceMesh>>(client_, call, input, options,
                                             &v1::Slicing::Stub::PrepareAsyncReadSurfaces),
      [&](const auto& surfaces) {
        return surfaces.size() == input.objects.size()
                   ? absl::OkStatus()
                   : Malformed("surfaces", "are not one for each object");
      });
}

}  // namespace slicefarm::coordinator
