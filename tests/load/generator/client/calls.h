#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/support/client_callback.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "common/rpc/status_mapping.h"
#include "tests/load/generator/algo/run_log.h"

/// Calls that occupy no thread while they are in progress. Their continuations run on gRPC's own
/// threads and must not block.
namespace slicefarm::load {

/// Values that all calls of a request share.
struct CallContext {
  std::chrono::system_clock::time_point deadline;
  bool retry = false;     ///< true if a refused call is repeated at the time that the server names
  RunLog* log = nullptr;  ///< must outlive the call
};

using Ended = std::function<void(absl::Status)>;
using Attempt = std::function<void(Ended)>;
template <typename T>
using Then = std::function<void(absl::StatusOr<T>)>;

/// Makes the attempt. With `context.retry`, repeats it after the time that a refusal names, as long
/// as the deadline allows. Logs the duration of a successful call under `step`.
void MakeCall(std::string_view step, const CallContext& context, Attempt attempt, Ended ended);

/// Makes one attempt of a method with one request and one response. `start`: the stub's async
/// method.
template <typename Response, typename Request, typename Start>
void StartUnary(const CallContext& context, const Request& request, const Start& start,
                Then<Response> then) {
  struct Call {
    grpc::ClientContext context;
    Request request;
    Response response;
  };
  auto call = std::make_shared<Call>();
  call->context.set_deadline(context.deadline);
  call->request = request;
  Call& made = *call;
  start(&made.context, &made.request, &made.response,
        [call = std::move(call), then = std::move(then)](const grpc::Status& status) mutable {
          auto outcome = status.ok() ? absl::StatusOr<Response>(std::move(call->response))
                                     : absl::StatusOr<Response>(rpc::FromGrpc(status));
          // The call is destroyed first, because it holds the channel. The continuation may release
          // all other references, and gRPC 1.51 aborts if the last one is released on one of its
          // own threads.
          call.reset();
          then(std::move(outcome));
        });
}

/// Reads a stream to its end. Deletes itself.
template <typename Response>
class StreamReader final : public grpc::ClientReadReactor<Response> {
 public:
  /// Functions that receive the events of a stream.
  struct Handler {
    std::function<void()> opened;  ///< called when the server reports that the stream is open
    std::function<void(const Response&)> take;
    Ended ended;
  };

  /// Starts the stream. `start`: the stub's async method, with the request bound.
  template <typename Start>
  static void Run(const CallContext& context, const Start& start, Handler handler) {
    auto* reader = new StreamReader(std::move(handler));
    reader->context_.set_deadline(context.deadline);
    start(&reader->context_, reader);
    reader->StartRead(&reader->response_);
    reader->StartCall();
  }

  void OnReadInitialMetadataDone(bool ok) override {
    if (ok && handler_.opened) handler_.opened();
  }
  void OnReadDone(bool ok) override {
    if (!ok) return;
    handler_.take(response_);
    this->StartRead(&response_);
  }
  void OnDone(const grpc::Status& status) override {
    const Ended ended = std::move(handler_.ended);
    absl::Status outcome = rpc::FromGrpc(status);
    delete this;  // first, for the reason in StartUnary
    ended(std::move(outcome));
  }

 private:
  explicit StreamReader(Handler handler) : handler_(std::move(handler)) {}

  grpc::ClientContext context_;
  Response response_;
  Handler handler_;
};

}  // namespace slicefarm::load
