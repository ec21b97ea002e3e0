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

/// Time limits of the calls of a remote stage.
struct RemoteOptions {
  /// Deadline of one try for very little work. A replica that has not answered by then counts as
  /// unreachable. The death of a machine or program is noticed earlier, because it breaks the
  /// connection.
  std::chrono::milliseconds deadline{300'000};
  /// number of outline points for which a call gets one more `deadline` of time
  int64_t points_a_deadline = 15'000'000;

  /// Returns the deadline of one try for work with `points` outline points.
  std::chrono::milliseconds DeadlineFor(int64_t points) const {
    const double times = 1 + static_cast<double>(points) / static_cast<double>(points_a_deadline);
    return std::chrono::duration_cast<std::chrono::milliseconds>(deadline * times);
  }
};

/// Returns the error for an answer that cannot be read or does not fit the call. Its code is
/// Internal, because the input is not at fault. `why` is returned unchanged if it is an error of
/// this program: out of memory, or cancelled.
absl::Status BadAnswer(std::string_view stage, const absl::Status& why);

/// Returns the outcome of a call that ended with `status`:
/// - LostCall if the call ended at its deadline or with its connection;
/// - BUILD_MISMATCH if the server does not have the method, because it is an older build, which
///   cannot report this itself;
/// - `status` in all other cases.
///
/// LostCall and BUILD_MISMATCH do not concern the input.
absl::Status OutcomeOf(std::string_view stage, std::chrono::milliseconds deadline,
                       absl::Status status);

/// Method of a gRPC stub that prepares a call with a stream of requests and a stream of responses.
template <typename Stub, typename Request, typename Response>
using Prepare = std::unique_ptr<grpc::ClientAsyncReaderWriter<Request, Response>> (Stub::*)(
    grpc::ClientContext*, grpc::CompletionQueue*);

/// Makes a call with streams in both directions on one of `replicas`. `write(stream)` sends the
/// request. `read(stream)` receives the answer; it must first drop the results of an earlier try.
/// `prepare`: the stub's PrepareAsync method. `deadline`: the deadline of one try. `stage`: name of
/// the stage in errors and spans. Returns the server's own status if the server sent one.
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
    // An answer that was cut off may be incomplete. In this case the status of the call is the
    // reason.
    const absl::Status outcome = OutcomeOf(stage, deadline, stream.Finish());
    return answer.ok() || !outcome.ok() ? outcome : BadAnswer(stage, answer);
  });
}

/// Makes a call as StreamOver does, but receives answers while it still writes the request.
/// `begin()` is called before each try and drops the results of an earlier try. `take(response)`
/// receives one answer.
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
