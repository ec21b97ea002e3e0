#include "services/coordinator/remote/remote_stages.h"

#include <utility>

#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/stage/exposure_job.h"
#include "common/stage/motion_job.h"
#include "common/stage/ordering_job.h"
#include "common/wire/fields/fields.h"
#include "common/wire/layers/exposure_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "common/wire/start_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "slicefarm/v1/beading.grpc.pb.h"
#include "slicefarm/v1/exposure.grpc.pb.h"
#include "slicefarm/v1/infill.grpc.pb.h"
#include "slicefarm/v1/motion.grpc.pb.h"
#include "slicefarm/v1/ordering.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

/// Writes one message per layer.
template <typename Request, typename Layers, typename Stream>
absl::Status WriteLayers(Stream& stream, const Layers& layers) {
  return WriteEach<Request>(stream, layers, [](const auto& layer, Request* request) {
    return ToProto(layer, request->mutable_layer());
  });
}

std::chrono::milliseconds DeadlineOf(const StageClient& client,
                                     const Neighbourhood& neighbourhood) {
  return client.options().DeadlineFor(PointsIn(neighbourhood.layers));
}

}  // namespace

absl::StatusOr<std::vector<WalledLayer>> RemoteBeading::Bead(
    const StageCall& call, const Neighbourhood& neighbourhood,
    const Shared<BeadingTable>& regions) const {
  return client_.ForRange(
      neighbourhood.range,
      client_.AskAbout<std::vector<WalledLayer>>(
          regions, StageStart{call, {}, neighbourhood.range}, DeadlineOf(client_, neighbourhood),
          &v1::Beading::Stub::PrepareAsyncBeadLayers, [&](auto& stream) {
            return WriteLayers<v1::BeadRequest>(stream, neighbourhood.layers);
          }));
}

absl::StatusOr<std::vector<FilledLayer>> RemoteInfill::Fill(
    const StageCall& call, std::vector<WalledLayer> walled, const Neighbourhood& neighbourhood,
    std::span<const LayerPlan> plans, const Shared<InfillTable>& regions) const {
  const auto write = [&](auto& stream) {
    const absl::Status status = WriteEach<v1::FillRequest>(
        stream, neighbourhood.layers, [](const SlicedLayer& layer, v1::FillRequest* request) {
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
  return client_.ForRange(
      neighbourhood.range,
      client_.AskAbout<std::vector<FilledLayer>>(regions, StageStart{call, {}, neighbourhood.range},
                                                 DeadlineOf(client_, neighbourhood),
                                                 &v1::Infill::Stub::PrepareAsyncFillLayers, write));
}

absl::StatusOr<std::vector<OrderedLayer>> RemoteOrdering::Order(
    const StageCall& call, std::vector<FilledLayer> layers, std::span<const LayerPlan> plans,
    const Shared<OrderingJob>& job) const {
  const auto write = [&](auto& stream) {
    auto plan = plans.begin();
    return WriteEach<v1::OrderRequest>(
        stream, layers, [&](const FilledLayer& layer, v1::OrderRequest* request) {
          absl::Status status = ToProto(*plan++, request->mutable_layer()->mutable_plan());
          request->mutable_layer()->mutable_plan()->clear_infill();  // the infill is done
          status.Update(ToProto(layer, request->mutable_layer()->mutable_layer()));
          return status;
        });
  };
  const LayerRange range = RangeOf(layers);
  return client_.ForRange(range, client_.AskAbout<std::vector<OrderedLayer>>(
                                     job, StageStart{call, {}, range}, client_.options().deadline,
                                     &v1::Ordering::Stub::PrepareAsyncOrderLayers, write));
}

absl::StatusOr<std::vector<LayerProgram>> RemoteMotion::Program(
    const StageCall& call, std::vector<OrderedLayer> layers, const Shared<MotionJob>& job) const {
  const LayerRange range = RangeOf(layers);
  return client_.Fitting(
      client_.AskAbout<std::vector<LayerProgram>>(
          job, StageStart{call, {}, range}, client_.options().deadline,
          &v1::Motion::Stub::PrepareAsyncProgramLayers,
          [&](auto& stream) { return WriteLayers<v1::ProgramRequest>(stream, layers); }),
      [&](const auto& programs) { return CheckProgramsOfRange(programs, range); });
}

absl::StatusOr<ProgramEnvelope> RemoteMotion::Envelope(const StageCall& call,
                                                       const ProgramSummary& summary,
                                                       const MotionOptions& options) const {
  v1::ProgramEnvelopeRequest request;
  *request.mutable_call() = ToProto(call);
  request.set_options(PackFields(options));
  if (absl::Status status = ToProto(summary, &request); !status.ok()) return status;
  return client_.AskOnce<ProgramEnvelope>(call, request, &v1::Motion::Stub::AsyncFrameProgram);
}

absl::StatusOr<std::vector<ExposedProgram>> RemoteExposure::Expose(
    const StageCall& call, const Neighbourhood& neighbourhood,
    const Shared<ExposureJob>& job) const {
  return client_.ForRange(
      neighbourhood.range,
      client_.AskAbout<std::vector<ExposedProgram>>(
          job, StageStart{call, {}, neighbourhood.range}, DeadlineOf(client_, neighbourhood),
          &v1::Exposure::Stub::PrepareAsyncExposeLayers, [&](auto& stream) {
            return WriteLayers<v1::ExposeRequest>(stream, neighbourhood.layers);
          }));
}

absl::StatusOr<ExposureEnvelope> RemoteExposure::Envelope(const StageCall& call,
                                                          const ExposureSummary& summary,
                                                          const ExposureSettings& settings) const {
  v1::ExposureEnvelopeRequest request;
  *request.mutable_call() = ToProto(call);
  request.set_settings(PackFields(settings));
  if (absl::Status status = ToProto(summary, &request); !status.ok()) return status;
  return client_.AskOnce<ExposureEnvelope>(call, request, &v1::Exposure::Stub::AsyncFrameExposure);
}

}  // namespace slicefarm::coordinator
