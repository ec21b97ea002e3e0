#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/rpc/client/client_call.h"
#include "common/stage/stages.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/shared_wire.h"
#include "services/coordinator/remote/remote_call.h"
#include "services/coordinator/remote/replica_source.h"
#include "services/coordinator/remote/shared_sends.h"

namespace slicefarm::coordinator {

/// Function that converts a response to a model and adds it to the result. The result is a vector
/// with one model per message, or a single model.
struct TakeModel {
  template <typename Response, typename Model>
  absl::Status operator()(Response& response, std::vector<Model>& models) const {
    return Append(FromProto(std::move(response)), &models);
  }
  template <typename Response, typename Model>
  absl::Status operator()(Response& response, std::optional<Model>& model) const {
    absl::StatusOr<Model> taken = FromProto(std::move(response));
    if (taken.ok()) model = *std::move(taken);
    return taken.status();
  }
};

/// Function for calls without further requests: writes nothing after the first message.
struct WriteNoMore {
  template <typename Stream>
  absl::Status operator()(Stream& /*stream*/) const {
    return absl::OkStatus();
  }
};

/// Calls the services of one stage. Each call runs on one of `replicas`, which must outlive the
/// client. A call has a deadline, and its cancellation also ends the computation on the server.
/// Errors: errors of the stage; Unavailable, DeadlineExceeded, Cancelled; Internal for an answer
/// that does not fit the call. Thread-safe.
class StageClient {
 public:
  /// Creates a client. `stage`: name of the stage in messages and spans.
  StageClient(std::string_view stage, ReplicaSource& replicas, const RemoteOptions& options)
      : stage_(stage), replicas_(replicas), options_(options), sends_(options.deadline) {}

  /// Returns the time limits of the calls.
  const RemoteOptions& options() const { return options_; }

  /// Calls a method with streams in both directions. `write(stream)` sends the request.
  /// `take(response, result)` adds one response to the result. Each try begins with an empty
  /// result.
  template <typename Result, typename Stub, typename Request, typename Response, typename Write,
            typename Take = TakeModel>
  absl::StatusOr<Result> Ask(const StageCall& call, std::chrono::milliseconds deadline,
                             Prepare<Stub, Request, Response> prepare, const Write& write,
                             const Take& take = {}) const {
    return AskOver<Result>(replicas_, call, deadline, prepare, write, take);
  }

  /// Calls a method with the first message `start`. This message refers to `job` by its digest, so
  /// each server gets the job only once. `write(stream)` sends the messages after the first.
  template <typename Result, typename Job, typename Start, typename Stub, typename Request,
            typename Response, typename Write = WriteNoMore, typename Take = TakeModel>
  absl::StatusOr<Result> AskAbout(const Shared<Job>& job, Start start,
                                  std::chrono::milliseconds deadline,
                                  Prepare<Stub, Request, Response> prepare, const Write& write = {},
                                  const Take& take = {}) const {
    const absl::StatusOr<SharedParts> parts = OnePart(job);
    if (!parts.ok()) return parts.status();
    start.shared = parts->front()->digest;
    SharingReplicas replicas(replicas_, sends_, start.call, *parts);
    const auto write_all = [&](auto& stream) {
      absl::Status begun = WriteStart<Request>(stream, start);
      return begun.ok() ? write(stream) : begun;
    };
    return AskOver<Result>(replicas, start.call, deadline, prepare, write_all, take);
  }

  /// Calls a method with one request and one response, and converts the response to a Model.
  template <typename Model, typename Stub, typename Request, typename Response>
  absl::StatusOr<Model> AskOnce(const StageCall& call, const Request& request,
                                std::unique_ptr<grpc::ClientAsyncResponseReader<Response>> (
                                    Stub::*start)(grpc::ClientContext*, const Request&,
                                                  grpc::CompletionQueue*)) const {
    Response response;
    const absl::Status status = replicas_.Call(call.cancel, [&](const auto& channel) {
      Stub stub(channel);
      const absl::Status outcome = rpc::UnaryCall(
          {options_.deadline, call.cancel, ChildSpan(call.trace, stage_)}, request, &response,
          [&](auto&&... arguments) { return (stub.*start)(arguments...); });
      return OutcomeOf(stage_, options_.deadline, outcome);
    });
    if (!status.ok()) return status;
    absl::StatusOr<Model> model = FromProto(std::move(response));
    if (!model.ok()) return BadAnswer(stage_, model.status());
    return model;
  }

  /// Returns the result if `check` accepts it. Errors: errors of the call; Internal (BadAnswer) if
  /// `check` returns an error.
  template <typename Result, typename Check>
  absl::StatusOr<Result> Fitting(absl::StatusOr<Result> result, const Check& check) const {
    if (!result.ok()) return result;
    if (absl::Status fits = check(*result); !fits.ok()) return BadAnswer(stage_, fits);
    return result;
  }

  /// Returns the results if there is exactly one for each layer of the range. Errors: as in
  /// Fitting.
  template <typename Layers>
  absl::StatusOr<Layers> ForRange(LayerRange range, absl::StatusOr<Layers> layers) const {
    return Fitting(std::move(layers),
                   [range](const Layers& found) { return CheckLayersOfRange(found, range); });
  }

  /// Returns the model of a call with one answer. Errors: errors of the call; Internal (BadAnswer)
  /// if there was no answer.
  template <typename Model>
  absl::StatusOr<Model> OnlyOne(absl::StatusOr<std::optional<Model>> model) const {
    if (!model.ok()) return model.status();
    if (!*model) return BadAnswer(stage_, Malformed("answer", "is missing"));
    return **std::move(model);
  }

 private:
  template <typename Result, typename Stub, typename Request, typename Response, typename Write,
            typename Take>
  absl::StatusOr<Result> AskOver(ReplicaSource& replicas, const StageCall& call,
                                 std::chrono::milliseconds deadline,
                                 Prepare<Stub, Request, Response> prepare, const Write& write,
                                 const Take& take) const {
    Result result;
    size_t count = 0;
    const auto begin = [&] {
      result = Result();
      count = 0;
    };
    const auto take_next = [&](Response& response) {
      const size_t index = count++;
      const absl::Status taken = take(response, result);
      return taken.ok() ? taken : Within("message", index, taken);
    };
    const absl::Status status =
        DuplexOver(replicas, deadline, call, stage_, prepare, begin, write, take_next);
    if (!status.ok()) return status;
    return result;
  }

  const std::string_view stage_;
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  mutable SharedSends sends_;  // values that are being sent
};

}  // namespace slicefarm::coordinator
