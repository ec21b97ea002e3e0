#include "services/slicing/server/slicing_service.h"

#include <utility>
#include <vector>

#include "common/rpc/server/limited_service.h"
#include "common/wire/engraving/surface_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/placed_scene_wire.h"
#include "common/wire/slicing_wire.h"
#include "common/wire/support/wire_error.h"
#include "slicefarm/v1/slicing.grpc.pb.h"

namespace slicefarm::slicing {
namespace {

/// Memory per byte of a file: its bytes, the mesh read from it, and the connected mesh.
constexpr int64_t kMemoryPerFileByte = 3;

struct Request {
  std::unique_ptr<MemoryBudget::Share> memory;
  StageCall call;
  SliceInput input;
  SlicingOptions options;
};

/// Reads the request of a method as soon as there is memory for it.
template <typename Stream>
absl::StatusOr<Request> ReadRequest(rpc::Call& call, Stream& stream, MemoryBudget& memory) {
  absl::StatusOr<SliceStart> start = ReadStart<v1::SliceRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  call.job_id = start->call.job_id;
  auto share = memory.Take({}, call.job_id, kMemoryPerFileByte * start->files.size(), call.cancel);
  if (!share.ok()) return share.status();
  absl::Status status = ReadEach<v1::SliceRequest>(
      stream, [&](const v1::SliceRequest& request) { return start->files.Add(request.chunk()); });
  status.Update(call.cancel.Check());
  if (!status.ok()) return status;
  absl::StatusOr<SliceInput> input = start->files.Finish();
  if (!input.ok()) return input.status();
  start->call.memory = share->get();
  return Request{*std::move(share), std::move(start->call), *std::move(input),
                 std::move(start->options)};
}

template <typename Stream>
absl::Status Answer(const SlicedJob& job, Stream& stream) {
  v1::SliceResponse summary;
  if (absl::Status status = ToProto(job, summary.mutable_summary()); !status.ok()) return status;
  stream.Write(summary);  // a gone client is detected at the first layer
  return WriteEach<v1::SliceResponse>(stream, job.layers,
                                      [](const SlicedLayer& layer, v1::SliceResponse* proto) {
                                        return ToProto(layer, proto->mutable_layer());
                                      });
}

template <typename Stream>
absl::Status Answer(const PlacedScene& scene, Stream& stream) {
  v1::PlaceResponse response;
  if (absl::Status status = ToProto(scene, response.mutable_scene()); !status.ok()) return status;
  stream.Write(response);  // a gone client is detected at the first piece
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

template <typename Stream>
absl::Status Answer(const std::vector<PlatePosition>& places, Stream& stream) {
  return WriteEach<v1::PlatePosition>(
      stream, places,
      [](const PlatePosition& place, v1::PlatePosition* proto) { return ToProto(place, proto); });
}

template <typename Stream>
absl::Status Answer(const std::vector<SurfaceMesh>& surfaces, Stream& stream) {
  return WriteEach<v1::SurfaceMesh>(
      stream, surfaces,
      [](const SurfaceMesh& mesh, v1::SurfaceMesh* proto) { return ToProto(mesh, proto); });
}

template <typename Stream>
absl::Status Answer(const v1::ReadProjectResponse& project, Stream& stream) {
  stream.Write(project);  // a gone client is no error
  return absl::OkStatus();
}

/// Serves a method with files in its request: `make(request)` returns the answer.
template <typename Make>
auto FromFiles(MemoryBudget& memory, const Make& make) {
  return [&memory, make](rpc::Call& call, auto& stream) -> absl::Status {
    absl::StatusOr<Request> request = ReadRequest(call, stream, memory);
    if (!request.ok()) return request.status();
    const auto made = make(*request);
    if (!made.ok()) return made.status();
    return Answer(*made, stream);
  };
}

absl::StatusOr<v1::ReadProjectResponse> ReadOne(const ReadProjects& projects,
                                                const Request& request) {
  if (request.input.files.size() != 1) return Malformed("start.files", "are not one");
  return projects(request.input.files.front(), request.call.cancel);
}

}  // namespace

std::unique_ptr<grpc::Service> MakeSlicingService(const SlicingStage& slicing,
                                                  const ArrangingStage& arranging,
                                                  const PlacingStage& placing,
                                                  ReadProjects projects, rpc::CallLimiter& gate,
                                                  int threads, MemoryBudget& memory) {
  using Service = v1::Slicing::Service;
  auto service = std::make_unique<rpc::LimitedService<v1::Slicing>>(gate);
  service->Add("Slice", &Service::Slice, FromFiles(memory, [&slicing, threads](Request& request) {
                 request.call.threads = threads;
                 return slicing.Slice(request.call, std::move(request.input), request.options);
               }));
  service->Add("PutOnPlates", &Service::PutOnPlates, FromFiles(memory, [&](Request& request) {
                 return arranging.PutOnPlates(request.call, std::move(request.input),
                                              request.options);
               }));
  service->Add("Place", &Service::Place, FromFiles(memory, [&](Request& request) {
                 return placing.Place(request.call, std::move(request.input), request.options);
               }));
  service->Add("ReadSurfaces", &Service::ReadSurfaces, FromFiles(memory, [&](Request& request) {
                 return placing.ReadSurfaces(request.call, std::move(request.input),
                                             request.options);
               }));
  service->Add("ReadProject", &Service::ReadProject,
               FromFiles(memory, [projects = std::move(projects)](const Request& request) {
                 return ReadOne(projects, request);
               }));
  return service;
}

}  // namespace slicefarm::slicing
