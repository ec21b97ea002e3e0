#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "absl/status/status.h"
#include "common/rpc/client/client_call.h"
#include "common/rpc/client/duplex_call.h"
#include "common/stage/object_layers.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "services/coordinator/remote/replica_source.h"

namespace slicefarm::coordinator {

/// Bounds of a remote stage's calls.
struct RemoteOptions {
  /// Of one try with next to no work. A replica that has not answered by then counts as away; one
  /// whose machine or process is gone does so earlier, by its connection.
  std::chrono::milliseconds deadline{300'000};
  /// Of outlines: for so many, a try may take once more as long.
  int64_t points_a_deadline = 15'000'000;

  std::chrono::milliseconds DeadlineFor(int64_t points) const {
    const double times = 1 + static_cast<double>(points) / static_cast<double>(points_a_deadline);
    return std::chrono::duration_cast<std::chrono::milliseconds>(deadline * times);
  }
};

/// A server that answers what cannot be read or does not fit: Internal, because the input is not at
/// fault. Why an answer was not taken here stays what it is: that there is no room, or no wish for
/// it.
absl::Status BadAnswer(std::string_view stage, const absl::Status& why);

/// `status` of a call; LostCall if it ended at our deadline or with its connection, and
/// BUILD_MISMATCH if the server does not know the method: neither says anything of the input. An
/// older build may lack a method that this one has, and so has no call whose build it could refuse.
absl::Status OutcomeOf(std::string_view stage, std::chrono::milliseconds deadline,
                       absl::Status status);

template <typename Stub, typename Request, typename Response>
using Prepare = std::unique_ptr<grpc::ClientAsyncReaderWriter<Request, Response>> (Stub::*)(
    grpc::ClientContext*, grpc::CompletionQueue*);

/// Makes a call of a method with streams both ways on one of `replicas`: `write(stream)` sends the
/// request, `read(stream)` takes the answer and drops what an earlier try left. `prepare` is the
/// stub's PrepareAsync method, `deadline` that of a try. The result is the server's word where it
/// gave one.
template <typename Stub, typename Request, typename Response, typename Write, typename Read>
absl::Status StreamOver(ReplicaSource& replicas, std::chrono::milliseconds deadline,
                        const StageCall& call, std::string_view stage,
                        Prepare<Stub, Request, Response> prepare, const Write& write,
                        const Read& read) {
  return replicas.Call(call.cancel, [&](const std::shared_ptr<grpc::Channel>& channel) {
    rpc::StreamCall<Request, Response> stream(
        {deadline, call.cancel, ChildSpan(call.trace, stage)},
        [&](auto* context, auto* queue) { return (Stub(channel).*prepare)(context, queue); });
    const absl::Status written = write(stream);
    if (!stream.alive()) return OutcomeOf(stage, deadline, stream.Finish());
    if (!written.ok()) return stream.Abandon(written);
    stream.WritesDone();
    const absl::Status answer = read(stream);
    if (!answer.ok() && stream.alive()) return stream.Abandon(BadAnswer(stage, answer));
    // An answer that was cut off may not fit: then the call's end says why.
    const absl::Status outcome = OutcomeOf(stage, deadline, stream.Finish());
    return answer.ok() || !outcome.ok() ? outcome : BadAnswer(stage, answer);
  });
}

/// The same, with answers that are taken while the request is written: `begin()` drops what an
/// earlier try left, `take(response)` takes an answer.
template <typename Stub, typename Request, typename Response, typename Begin, typename Write,
          typename Take>
absl::Status DuplexOver(ReplicaSource& replicas, std::chrono::milliseconds deadline,
                        const StageCall& call, std::string_view stage,
                        Prepare<Stub, Request, Response> prepare, const Begin& begin,
                        const Write& write, const Take& take) {
  return replicas.Call(call.cancel, [&](const std::shared_ptr<grpc::Channel>& channel) {
    begin();
    absl::Status taken;
    rpc::DuplexCall<Request, Response> stream(
        {deadline, call.cancel, ChildSpan(call.trace, stage)},
        [&](auto* context, auto* queue) { return (Stub(channel).*prepare)(context, queue); },
        [&](Response& response) { return taken = take(response); });
    const absl::Status written = write(stream);
    if (!written.ok() && stream.alive()) return stream.Abandon(written);
    const absl::Status outcome = stream.Finish();
    return taken.ok() ? OutcomeOf(stage, deadline, outcome) : BadAnswer(stage, taken);
  });
}

}  // namespace slicefarm::coordinator
