#pragma once

#include <string_view>

#include "common/wire/slicing_wire.h"
#include "slicefarm/v1/slicing.pb.h"

namespace slicefarm::coordinator {

/// Begins a call of the slicing service and sends the bytes of its files. Stops early if the server
/// has ended the call; the status of the call then gives the reason.
template <typename Stream>
absl::Status WriteFiles(Stream& stream, const StageCall& call, const SliceInput& input,
                        const SlicingOptions& options) {
  v1::SliceRequest request;
  absl::Status status = ToProto(call, input, options, request.mutable_start());
  if (!status.ok() || !stream.Write(request)) return status;
  ForEachChunk(input, [&](std::string_view chunk) {
    request.set_chunk(chunk.data(), chunk.size());
    return stream.Write(request);
  });
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
