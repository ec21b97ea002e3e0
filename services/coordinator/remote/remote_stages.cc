#include "services/coordinator/remote/remote_stages.h"

#include <utility>

#include "common/model/limits.h"
#include "common/rpc/client/client_call.h"
#include "common/stage/job_memory.h"
#include "common/stage/print_layers.h"
#include "common/wire/engraving/surface_wire.h"
#include "common/wire/layers/exposure_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/placed_scene_wire.h"
#include "common/wire/slicing_wire.h"
#include "common/wire/fields/fields.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/message_stream.h"
#include "common/wire/support/repeated_wire.h"
#include "services/coordinator/remote/slice_files.h"
#include "slicefarm/v1/beading.grpc.pb.h"
#include "slicefarm/v1/exposure.grpc.pb.h"
#include "slicefarm/v1/infill.grpc.pb.h"
#include "slicefarm/v1/motion.grpc.pb.h"
#include "slicefarm/v1/ordering.grpc.pb.h"
#include "slicefarm/v1/planning.grpc.pb.h"
#include "slicefarm/v1/slicing.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

/// Before it is read, nobody can tell how many outlines a mesh has: a small file may have the most.
int64_t MostPoints() { return limits::kMaxPointsPerJob; }

constexpr char kSlicing[] = "slicing";
constexpr char kPlacing[] = "placing";
constexpr char kPlanning[] = "planning";
constexpr char kBeading[] = "beading";
constexpr char kInfill[] = "infill";
constexpr char kOrdering[] = "ordering";
constexpr char kMotion[] = "motion";
constexpr char kExposure[] = "exposure";

template <typename Layers>
absl::StatusOr<Layers> ForRange(Layers layers, LayerRange range, std::string_view stage) {
  const absl::Status status = CheckLayersOfRange(layers, range);
  if (!status.ok()) return BadAnswer(stage, status);
  return layers;
}

/// That the peer is gone shows at what is written next.
template <typename Request, typename Stream, typename Start>
absl::Status WriteStart(Stream& stream, const Start& start) {
  Request request;
  absl::Status status = ToProto(start, request.mutable_start());
  if (status.ok()) stream.Write(request);
  return status;
}

/// Takes all answers, of a message each.
template <typename Response, typename Model, typename Stream>
absl::Status ReadAll(Stream& stream, std::vector<Model>* models) {
  models->clear();
  return ReadEach<Response>(stream, [models](Response& response) {
    return Append(FromProto(std::move(response)), models);
  });
}

template <typename Stream>
absl::Status ReadJob(Stream& stream, const StageCall& call, SlicedJob* job, int32_t* layer_count) {
  v1::SliceResponse first;
  if (!stream.Read(&first)) return absl::OkStatus();  // the call's end says why
  absl::StatusOr<SlicedJob> summary = FromProto(first.summary());
  if (!summary.ok()) return summary.status();
  *job = *std::move(summary);
  *layer_count = first.summary().layer_count();
  int64_t bytes = 0;
  return ReadEach<v1::SliceResponse>(stream, [&](const v1::SliceResponse& response) {
    absl::Status taken = Append(FromProto(response.layer()), &job->layers);
    if (!taken.ok()) return taken;
    bytes += MemoryOf(job->layers.back());
    return HoldMemory(call, JobMemory::Kind::kOutlines, bytes);
  });
}

template <typename Stream>
absl::Status ReadScene(Stream& stream, const StageCall& call, PlacedScene* scene) {
  v1::PlaceResponse first;
  if (!stream.Read(&first)) return absl::OkStatus();  // the call's end says why
  absl::StatusOr<PlacedScene> placed = FromProto(first.scene());
  if (!placed.ok()) return placed.status();
  absl::StatusOr<MeshReader> meshes = MeshReader::Begin(MeshSizesOf(first.scene()));
  if (!meshes.ok()) return meshes.status();
  const absl::Status read = ReadEach<v1::PlaceResponse>(
      stream, [&](const v1::PlaceResponse& response) { return meshes->Add(response.piece()); });
  if (!read.ok()) return read;
  auto whole = meshes->Finish();
  if (!whole.ok()) return whole.status();
  *scene = *std::move(placed);
  PutMeshes(*std::move(whole), *scene);
  return HoldMemory(call, JobMemory::Kind::kMeshes, MemoryOf(*scene));
}

}  // namespace

absl::StatusOr<SlicedJob> RemoteSlicing::Slice(const StageCall& call, SliceInput input,
                                               const SlicingOptions& options) const {
  SlicedJob job;
  int32_t layer_count = 0;
  const absl::Status status = StreamOver(
      replicas_, options_.DeadlineFor(MostPoints()), call, kSlicing,
      &v1::Slicing::Stub::PrepareAsyncSlice,
      [&](auto& stream) { return WriteFiles(stream, call, input, options); },
      [&](auto& stream) { return ReadJob(stream, call, &job, &layer_count); });
  if (!status.ok()) return status;
  if (layer_count == 0) return job;
  absl::StatusOr<std::vector<SlicedLayer>> layers =
      ForRange(std::move(job.layers), {0, layer_count}, kSlicing);
  if (!layers.ok()) return layers.status();
  job.layers = *std::move(layers);
  return job;
}

absl::StatusOr<std::vector<PlatePlace>> RemoteArranging::PutOnPlates(
    const StageCall& call, SliceInput input, const SlicingOptions& options) const {
  std::vector<PlatePlace> places;
  const absl::Status status = StreamOver(
      replicas_, options_.DeadlineFor(MostPoints()), call, kSlicing,
      &v1::Slicing::Stub::PrepareAsyncPutOnPlates,
      [&](auto& stream) { return WriteFiles(stream, call, input, options); },
      [&](auto& stream) { return ReadAll<v1::PlatePlace>(stream, &places); });
  if (!status.ok()) return status;
  size_t copies = 0;
  for (const ObjectInput& object : input.objects) copies += object.copies.size();
  if (places.size() != copies)
    return BadAnswer(kSlicing, Malformed("places", "are not one for each copy"));
  return places;
}

absl::StatusOr<PlacedScene> RemotePlacing::Place(const StageCall& call, SliceInput input,
                                                 const SlicingOptions& options) const {
  PlacedScene scene;
  const absl::Status status = StreamOver(
      replicas_, options_.DeadlineFor(MostPoints()), call, kPlacing,
      &v1::Slicing::Stub::PrepareAsyncPlace,
      [&](auto& stream) { return WriteFiles(stream, call, input, options); },
      [&](auto& stream) { return ReadScene(stream, call, &scene); });
  if (!status.ok()) return status;
  return scene;
}

absl::StatusOr<std::vector<SurfaceMesh>> RemotePlacing::ReadSurfaces(
    const StageCall& call, SliceInput input, const SlicingOptions& options) const {
  std::vector<SurfaceMesh> surfaces;
  const absl::Status status = StreamOver(
      replicas_, options_.DeadlineFor(MostPoints()), call, kPlacing,
      &v1::Slicing::Stub::PrepareAsyncReadSurfaces,
      [&](auto& stream) { return WriteFiles(stream, call, input, options); },
      [&](auto& stream) { return ReadAll<v1::SurfaceMesh>(stream, &surfaces); });
  if (!status.ok()) return status;
  if (surfaces.size() != input.objects.size())
    return BadAnswer(kPlacing, Malformed("surfaces", "are not one for each object"));
  return surfaces;
}

absl::StatusOr<JobPlan> RemotePlanning::Plan(const StageCall& call, const SlicedOutlines& job,
                                             const PlanningOptions& options) const {
  JobPlan plan;
  bool ended = false;
  int64_t bytes = 0;
  const auto begin = [&] {
    plan = {};
    ended = false;
    bytes = 0;
  };
  const auto write = [&](auto& stream) {
    absl::Status status = WriteStart<v1::PlanRequest>(
        stream, PlanStart{call,
                          options,
                          {job.copies.begin(), job.copies.end()},
                          {job.object_names.begin(), job.object_names.end()}});
    if (!status.ok()) return status;
    return WriteEach<v1::PlanRequest>(stream, job.layers,
                                      [](const SlicedLayer& layer, v1::PlanRequest* request) {
                                        return ToProto(layer, request->mutable_layer());
                                      });
  };
  const auto hold = [&](absl::Status taken, auto& last) {
    if (!taken.ok()) return taken;
    bytes += MemoryOf(last.back());
    return HoldMemory(call, JobMemory::Kind::kPlan, bytes);
  };
  const auto take = [&](const v1::PlanResponse& response) -> absl::Status {
    if (response.has_layer())
      return hold(Append(FromProto(response.layer()), &plan.layers), plan.layers);
    if (response.has_stack()) return Append(FromProto(response.stack()), &plan.stacks);
    if (response.has_section()) {
      if (plan.stacks.empty()) return Malformed("section", "is of no stack");
      std::vector<ObjectSection>& sections = plan.stacks.back().sections;
      return hold(Append(FromProto(response.section()), &sections), sections);
    }
    if (response.has_skirt()) {
      absl::StatusOr<Skirt> skirt = FromProto(response.skirt());
      if (!skirt.ok()) return skirt.status();
      plan.skirt = *std::move(skirt);
      bytes += MemoryOf(plan.skirt);
      return HoldMemory(call, JobMemory::Kind::kPlan, bytes);
    }
    ended = response.has_end();
    const absl::StatusOr<SeamQuality> seams = FromProto(response.end().seams());
    if (!seams.ok()) return seams.status();
    plan.seams = *seams;
    plan.notes.assign(response.end().notes().begin(), response.end().notes().end());
    plan.warnings.assign(response.end().warnings().begin(), response.end().warnings().end());
    for (const int64_t lift_nm : response.end().lifts_nm())
      if (absl::Status ok = CheckLift("lifts_nm", lift_nm); !ok.ok()) return ok;
    plan.lifts_nm.assign(response.end().lifts_nm().begin(), response.end().lifts_nm().end());
    return AllFromProto(response.end().copies(), "copies", &plan.copies);
  };
  const absl::Status status =
      DuplexOver(replicas_, options_.DeadlineFor(PointsIn(job.layers)), call, kPlanning,
                 &v1::Planning::Stub::PrepareAsyncPlanJob, begin, write, take);
  if (!status.ok()) return status;
  if (!ended || plan.layers.size() != PrintLayerCount(job.layers, plan.lifts_nm, plan.stacks) ||
      plan.copies.size() != job.copies.size())
    return BadAnswer(kPlanning, Malformed("layer", "not a plan for each layer and copy"));
  return plan;
}

absl::StatusOr<std::vector<WalledLayer>> RemoteBeading::Bead(
    const StageCall& call, const Neighbourhood& neighbourhood,
    const Shared<BeadingTable>& regions) const {
  const absl::StatusOr<SharedParts> parts = OnePart(regions);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::vector<WalledLayer> walled;
  const absl::Status status = StreamOver(
      replicas, options_.DeadlineFor(PointsIn(neighbourhood.layers)), call, kBeading,
      &v1::Beading::Stub::PrepareAsyncBeadLayers,
      [&](auto& stream) {
        absl::Status started = WriteStart<v1::BeadRequest>(
            stream, BeadStart{call, parts->front()->digest, neighbourhood.range});
        if (!started.ok()) return started;
        return WriteEach<v1::BeadRequest>(stream, neighbourhood.layers,
                                          [](const SlicedLayer& layer, v1::BeadRequest* request) {
                                            return ToProto(layer, request->mutable_layer());
                                          });
      },
      [&](auto& stream) { return ReadAll<v1::WalledLayer>(stream, &walled); });
  if (!status.ok()) return status;
  return ForRange(std::move(walled), neighbourhood.range, kBeading);
}

absl::StatusOr<std::vector<FilledLayer>> RemoteInfill::Fill(
    const StageCall& call, std::vector<WalledLayer> walled, const Neighbourhood& neighbourhood,
    std::span<const LayerPlan> plans, const Shared<InfillTable>& regions) const {
  const absl::StatusOr<SharedParts> parts = OnePart(regions);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::vector<FilledLayer> filled;
  const auto write = [&](auto& stream) {
    absl::Status status = WriteStart<v1::FillRequest>(
        stream, FillStart{call, parts->front()->digest, neighbourhood.range});
    if (!status.ok()) return status;
    status = WriteEach<v1::FillRequest>(stream, neighbourhood.layers,
                                        [](const SlicedLayer& layer, v1::FillRequest* request) {
                                          return ToProto(layer, request->mutable_neighbour());
                                        });
    if (!status.ok()) return status;
    auto plan = plans.begin();
    return WriteEach<v1::FillRequest>(
        stream, walled, [&](const WalledLayer& layer, v1::FillRequest* request) {
          absl::Status put =
              AllToProto((plan++)->infill, "infill", request->mutable_layer()->mutable_infill());
          put.Update(ToProto(layer, request->mutable_layer()->mutable_layer()));
          return put;
        });
  };
  const absl::Status status =
      StreamOver(replicas, options_.DeadlineFor(PointsIn(neighbourhood.layers)), call, kInfill,
                 &v1::Infill::Stub::PrepareAsyncFillLayers, write,
                 [&](auto& stream) { return ReadAll<v1::FilledLayer>(stream, &filled); });
  if (!status.ok()) return status;
  return ForRange(std::move(filled), neighbourhood.range, kInfill);
}

absl::StatusOr<std::vector<OrderedLayer>> RemoteOrdering::Order(
    const StageCall& call, std::vector<FilledLayer> layers, std::span<const LayerPlan> plans,
    const Shared<OrderingJob>& job) const {
  const absl::StatusOr<SharedParts> parts = OnePart(job);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::vector<OrderedLayer> ordered;
  const auto write = [&](auto& stream) {
    absl::Status started =
        WriteStart<v1::OrderRequest>(stream, OrderStart{call, parts->front()->digest});
    if (!started.ok()) return started;
    auto plan = plans.begin();
    return WriteEach<v1::OrderRequest>(
        stream, layers, [&](const FilledLayer& layer, v1::OrderRequest* request) {
          absl::Status status = ToProto(*plan++, request->mutable_layer()->mutable_plan());
          request->mutable_layer()->mutable_plan()->clear_infill();  // it is done
          status.Update(ToProto(layer, request->mutable_layer()->mutable_layer()));
          return status;
        });
  };
  const absl::Status status = StreamOver(
      replicas, options_.deadline, call, kOrdering, &v1::Ordering::Stub::PrepareAsyncOrderLayers,
      write, [&](auto& stream) { return ReadAll<v1::OrderedLayer>(stream, &ordered); });
  if (!status.ok()) return status;
  return ForRange(std::move(ordered), RangeOf(layers), kOrdering);
}

absl::StatusOr<std::vector<LayerProgram>> RemoteMotion::Program(
    const StageCall& call, std::vector<OrderedLayer> layers, const Shared<MotionJob>& job) const {
  const absl::StatusOr<SharedParts> parts = OnePart(job);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::vector<LayerProgram> programs;
  const auto write = [&](auto& stream) {
    absl::Status started =
        WriteStart<v1::ProgramRequest>(stream, ProgramStart{call, parts->front()->digest});
    if (!started.ok()) return started;
    return WriteEach<v1::ProgramRequest>(
        stream, layers, [](const OrderedLayer& layer, v1::ProgramRequest* request) {
          return ToProto(layer, request->mutable_layer());
        });
  };
  const absl::Status status = StreamOver(
      replicas, options_.deadline, call, kMotion, &v1::Motion::Stub::PrepareAsyncProgramLayers,
      write, [&](auto& stream) { return ReadAll<v1::LayerProgram>(stream, &programs); });
  if (!status.ok()) return status;
  const absl::Status fits = CheckProgramsOfRange(programs, RangeOf(layers));
  if (!fits.ok()) return BadAnswer(kMotion, fits);
  return programs;
}

absl::StatusOr<ProgramEnvelope> RemoteMotion::Envelope(const StageCall& call,
                                                       const ProgramSummary& summary,
                                                       const MotionOptions& options) const {
  v1::FrameRequest request;
  *request.mutable_call() = ToProto(call);
  request.set_options(PackFields(options));
  if (absl::Status status = ToProto(summary, &request); !status.ok()) return status;
  v1::ProgramFrame response;
  const absl::Status status = replicas_.Call(call.cancel, [&](const auto& channel) {
    const auto stub = v1::Motion::NewStub(channel);
    return OutcomeOf(
        kMotion, options_.deadline,
        rpc::UnaryCall({options_.deadline, call.cancel, ChildSpan(call.trace, kMotion)}, request,
                       &response,
                       [&](auto&&... arguments) { return stub->AsyncFrameProgram(arguments...); }));
  });
  if (!status.ok()) return status;
  absl::StatusOr<ProgramEnvelope> frame = FromProto(std::move(response));
  if (!frame.ok()) return BadAnswer(kMotion, frame.status());
  return frame;
}

absl::StatusOr<std::vector<ExposedProgram>> RemoteExposure::Expose(
    const StageCall& call, const Neighbourhood& neighbourhood,
    const Shared<ExposureJob>& job) const {
  const absl::StatusOr<SharedParts> parts = OnePart(job);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::vector<ExposedProgram> programs;
  const auto write = [&](auto& stream) {
    absl::Status started = WriteStart<v1::ExposeRequest>(
        stream, ExposeStart{call, parts->front()->digest, neighbourhood.range});
    if (!started.ok()) return started;
    return WriteEach<v1::ExposeRequest>(stream, neighbourhood.layers,
                                        [](const SlicedLayer& layer, v1::ExposeRequest* request) {
                                          return ToProto(layer, request->mutable_layer());
                                        });
  };
  const absl::Status status =
      StreamOver(replicas, options_.DeadlineFor(PointsIn(neighbourhood.layers)), call, kExposure,
                 &v1::Exposure::Stub::PrepareAsyncExposeLayers, write,
                 [&](auto& stream) { return ReadAll<v1::ExposedProgram>(stream, &programs); });
  if (!status.ok()) return status;
  return ForRange(std::move(programs), neighbourhood.range, kExposure);
}

absl::StatusOr<ExposureEnvelope> RemoteExposure::Envelope(const StageCall& call,
                                                          const ExposureSummary& summary,
                                                          const ExposureSettings& settings) const {
  v1::ExposureFrameRequest request;
  *request.mutable_call() = ToProto(call);
  request.set_settings(PackFields(settings));
  if (absl::Status status = ToProto(summary, &request); !status.ok()) return status;
  v1::ExposureFrame response;
  const absl::Status status = replicas_.Call(call.cancel, [&](const auto& channel) {
    const auto stub = v1::Exposure::NewStub(channel);
    return OutcomeOf(
        kExposure, options_.deadline,
        rpc::UnaryCall(
            {options_.deadline, call.cancel, ChildSpan(call.trace, kExposure)}, request, &response,
            [&](auto&&... arguments) { return stub->AsyncFrameExposure(arguments...); }));
  });
  if (!status.ok()) return status;
  return FromProto(std::move(response));
}

}  // namespace slicefarm::coordinator
