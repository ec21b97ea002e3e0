#include "services/slicing/server/slicing_service.h"

#include <utility>
#include <vector>

#include "common/rpc/server/server_stream.h"
#include "common/wire/engraving/surface_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/placed_scene_wire.h"
#include "common/wire/slicing_wire.h"
#include "common/wire/support/message_stream.h"
#include "common/wire/support/wire_error.h"
#include "slicefarm/v1/slicing.grpc.pb.h"

namespace slicefarm::slicing {
namespace {

class SlicingService final : public v1::Slicing::Service {
 public:
  SlicingService(const SlicingStage& slicing, const ArrangingStage& arranging,
                 const PlacingStage& placing, ReadProjects projects, rpc::CallGate& gate, int threads,
                 MemoryBudget& memory)
      : slicing_(slicing),
        arranging_(arranging),
        placing_(placing),
        projects_(std::move(projects)),
        gate_(gate),
        threads_(threads),
        memory_(memory) {}

  grpc::Status Slice(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::SliceResponse, v1::SliceRequest>* stream) override;
  grpc::Status PutOnPlates(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::PlatePlace, v1::SliceRequest>* stream) override;
  grpc::Status Place(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::PlaceResponse, v1::SliceRequest>* stream) override;
  grpc::Status ReadSurfaces(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::SurfaceMesh, v1::SliceRequest>* stream) override;
  grpc::Status ReadProject(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::ReadProjectResponse, v1::SliceRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::SliceResponse, v1::SliceRequest>;
  using SceneStream = rpc::ServerStream<v1::PlaceResponse, v1::SliceRequest>;
  using PlacesStream = rpc::ServerStream<v1::PlatePlace, v1::SliceRequest>;
  absl::Status SliceFiles(rpc::Call& call, Stream& stream) const;
  using ProjectStream = rpc::ServerStream<v1::ReadProjectResponse, v1::SliceRequest>;
  absl::Status ArrangeFiles(rpc::Call& call, PlacesStream& stream) const;
  using SurfaceStream = rpc::ServerStream<v1::SurfaceMesh, v1::SliceRequest>;
  absl::Status ReadFiles(rpc::Call& call, SurfaceStream& stream) const;
  absl::Status PlaceFiles(rpc::Call& call, SceneStream& stream) const;
  absl::Status ReadFile(rpc::Call& call, ProjectStream& stream) const;
  static absl::Status Answer(const SlicedJob& job, Stream& stream);
  static absl::Status Answer(const PlacedScene& scene, SceneStream& stream);

  const SlicingStage& slicing_;
  const ArrangingStage& arranging_;
  const PlacingStage& placing_;
  const ReadProjects projects_;
  rpc::CallGate& gate_;
  const int threads_;
  MemoryBudget& memory_;
};

/// A file's bytes, what they are read to, and what that is connected to.
constexpr int64_t kMemoryPerFileByte = 3;

struct Request {
  std::unique_ptr<MemoryBudget::Share> memory;
  StageCall call;
  SliceInput input;
  SlicingOptions options;
};

/// What both methods are asked with, once there is room for it.
template <typename Stream>
absl::StatusOr<Request> ReadRequest(rpc::Call& call, Stream& stream, MemoryBudget& memory) {
  absl::StatusOr<SliceStart> start = ReadStart<v1::SliceRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  call.job_id = start->call.job_id;
  auto room = memory.Take({}, call.job_id, kMemoryPerFileByte * start->files.size(), call.cancel);
  if (!room.ok()) return room.status();
  absl::Status status = ReadEach<v1::SliceRequest>(
      stream, [&](const v1::SliceRequest& request) { return start->files.Add(request.chunk()); });
  status.Update(call.cancel.Check());
  if (!status.ok()) return status;
  absl::StatusOr<SliceInput> input = start->files.Finish();
  if (!input.ok()) return input.status();
  start->call.memory = room->get();
  return Request{*std::move(room), std::move(start->call), *std::move(input),
                 std::move(start->options)};
}

}  // namespace

grpc::Status SlicingService::Slice(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::SliceResponse, v1::SliceRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "Slice", [&](rpc::Call& call) { return SliceFiles(call, buffered); });
}

grpc::Status SlicingService::PutOnPlates(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::PlatePlace, v1::SliceRequest>* stream) {
  PlacesStream buffered(*stream);
  return gate_.Run(*context, "PutOnPlates",
                   [&](rpc::Call& call) { return ArrangeFiles(call, buffered); });
}

grpc::Status SlicingService::Place(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::PlaceResponse, v1::SliceRequest>* stream) {
  SceneStream buffered(*stream);
  return gate_.Run(*context, "Place", [&](rpc::Call& call) { return PlaceFiles(call, buffered); });
}

grpc::Status SlicingService::ReadSurfaces(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::SurfaceMesh, v1::SliceRequest>* stream) {
  SurfaceStream buffered(*stream);
  return gate_.Run(*context, "ReadSurfaces",
                   [&](rpc::Call& call) { return ReadFiles(call, buffered); });
}

absl::Status SlicingService::ReadFiles(rpc::Call& call, SurfaceStream& stream) const {
  absl::StatusOr<Request> request = ReadRequest(call, stream, memory_);
  if (!request.ok()) return request.status();
  const auto surfaces =
      placing_.ReadSurfaces(request->call, std::move(request->input), request->options);
  if (!surfaces.ok()) return surfaces.status();
  return WriteEach<v1::SurfaceMesh>(
      stream, *surfaces,
      [](const SurfaceMesh& mesh, v1::SurfaceMesh* proto) { return ToProto(mesh, proto); });
}

grpc::Status SlicingService::ReadProject(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::ReadProjectResponse, v1::SliceRequest>* stream) {
  ProjectStream buffered(*stream);
  return gate_.Run(*context, "ReadProject",
                   [&](rpc::Call& call) { return ReadFile(call, buffered); });
}

absl::Status SlicingService::ReadFile(rpc::Call& call, ProjectStream& stream) const {
  absl::StatusOr<Request> request = ReadRequest(call, stream, memory_);
  if (!request.ok()) return request.status();
  if (request->input.files.size() != 1) return Malformed("start.files", "are not one");
  const auto project = projects_(request->input.files.front(), call.cancel);
  if (!project.ok()) return project.status();
  stream.Write(*project);  // that the client is gone is no error
  return absl::OkStatus();
}

absl::Status SlicingService::SliceFiles(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<Request> request = ReadRequest(call, stream, memory_);
  if (!request.ok()) return request.status();
  request->call.threads = threads_;
  const absl::StatusOr<SlicedJob> job =
      slicing_.Slice(request->call, std::move(request->input), request->options);
  if (!job.ok()) return job.status();
  return Answer(*job, stream);
}

absl::Status SlicingService::ArrangeFiles(rpc::Call& call, PlacesStream& stream) const {
  absl::StatusOr<Request> request = ReadRequest(call, stream, memory_);
  if (!request.ok()) return request.status();
  const auto places =
      arranging_.PutOnPlates(request->call, std::move(request->input), request->options);
  if (!places.ok()) return places.status();
  return WriteEach<v1::PlatePlace>(
      stream, *places,
      [](const PlatePlace& place, v1::PlatePlace* proto) { return ToProto(place, proto); });
}

absl::Status SlicingService::PlaceFiles(rpc::Call& call, SceneStream& stream) const {
  absl::StatusOr<Request> request = ReadRequest(call, stream, memory_);
  if (!request.ok()) return request.status();
  const auto scene = placing_.Place(request->call, std::move(request->input), request->options);
  if (!scene.ok()) return scene.status();
  return Answer(*scene, stream);
}

absl::Status SlicingService::Answer(const PlacedScene& scene, SceneStream& stream) {
  v1::PlaceResponse response;
  if (absl::Status status = ToProto(scene, response.mutable_scene()); !status.ok()) return status;
  stream.Write(response);  // that the client is gone shows at the first piece
  for (const PlacedSceneObject& object : scene.objects) {
    for (const PlacedScenePart& part : object.parts) {
      absl::Status sent = ForEachPiece(part.mesh, [&](const v1::MeshPiece& piece) {
        *response.mutable_piece() = piece;
        return stream.Write(response);
      });
      if (!sent.ok()) return sent;
    }
  }
  return absl::OkStatus();
}

absl::Status SlicingService::Answer(const SlicedJob& job, Stream& stream) {
  v1::SliceResponse summary;
  if (absl::Status status = ToProto(job, summary.mutable_summary()); !status.ok()) return status;
  stream.Write(summary);  // that the client is gone shows at the first layer
  return WriteEach<v1::SliceResponse>(stream, job.layers,
                                      [](const SlicedLayer& layer, v1::SliceResponse* proto) {
                                        return ToProto(layer, proto->mutable_layer());
                                      });
}

std::unique_ptr<grpc::Service> MakeSlicingService(const SlicingStage& slicing,
                                                  const ArrangingStage& arranging,
                                                  const PlacingStage& placing,
                                                  ReadProjects projects, rpc::CallGate& gate,
                                                  int threads, MemoryBudget& memory) {
  return std::make_unique<SlicingService>(slicing, arranging, placing, std::move(projects), gate,
                                          threads, memory);
}

}  // namespace slicefarm::slicing
