#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/program_wire.h"
#include "common/wire/support/message_stream.h"
#include "common/wire/task_wire.h"

namespace slicefarm {

/// What tasks of ranges of layers have in common on the wire.

/// `start`, then the layers. OK too if the peer is gone: it says why.
inline absl::Status SendWithLayers(const v1::WorkStart& start, std::span<const SlicedLayer> layers,
                                   CoordinatorEnd& end) {
  v1::WorkRequest request;
  *request.mutable_start() = start;
  if (!end.Write(request)) return absl::OkStatus();
  return WriteEach<v1::WorkRequest>(end, layers,
                                    [](const SlicedLayer& layer, v1::WorkRequest* message) {
                                      return ToProto(layer, message->mutable_layer());
                                    });
}

/// The layers that follow the start: those of its range and halo.
inline absl::StatusOr<std::vector<SlicedLayer>> ReceiveLayers(LayerRange range,
                                                              const CancelToken& cancel,
                                                              WorkerEnd& end) {
  struct Start {
    StageCall call;
    LayerRange range;
  } start;
  start.call.cancel = cancel;
  start.range = range;
  return ReadNeighbourhood<v1::WorkRequest>(end, start);
}

/// Ends what a task came to. A client that is gone needs no error.
inline void SendTimes(const StageTimes& times, WorkerEnd& end) {
  v1::WorkResponse response;
  *response.mutable_times() = ToProto(times);
  end.Write(response);
}

inline absl::Status TakeTimes(const v1::WorkResponse& response, StageTimes* times) {
  absl::StatusOr<StageTimes> taken = FromProto(response.times());
  if (taken.ok()) *times = *taken;
  return taken.status();
}

}  // namespace slicefarm
