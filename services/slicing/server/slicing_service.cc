#include "services/slicing/server/slicing_service.h"

#include <utility>
#include <vector>

#include "common/wire/layer_wire.h"
#include "common/wire/message_stream.h"
#include "common/wire/slicing_wire.h"

namespace slicefarm::slicing {

grpc::Status SlicingService::Slice(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::SliceResponse, v1::SliceRequest>* stream) {
  Stream buffered(*stream);
  return gate_.Run(*context, "Slice", [&](rpc::Call& call) { return SliceFiles(call, buffered); });
}

absl::Status SlicingService::SliceFiles(rpc::Call& call, Stream& stream) const {
  absl::StatusOr<SliceStart> start = ReadStart<v1::SliceRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  call.job_id = start->call.job_id;
  absl::Status status = ReadEach<v1::SliceRequest>(
      stream, [&](const v1::SliceRequest& request) { return start->files.Add(request.chunk()); });
  status.Update(call.cancel.Check());
  if (!status.ok()) return status;
  absl::StatusOr<SliceInput> input = start->files.Finish();
  if (!input.ok()) return input.status();

  start->call.threads = threads_;
  const absl::StatusOr<SlicedJob> job =
      stage_.Slice(start->call, *std::move(input), start->options);
  if (!job.ok()) return job.status();
  return Answer(*job, stream);
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

}  // namespace slicefarm::slicing
