#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/support/async_stream.h>
#include <grpcpp/support/async_unary_call.h>

#include <chrono>
#include <functional>
#include <memory>
#include <utility>

#include "absl/status/status.h"
#include "common/base/cancel_token.h"
#include "common/base/trace_context.h"

namespace slicefarm::rpc {

/// Deadline, cancellation and trace of a call.
struct ClientCallOptions {
  std::chrono::milliseconds deadline{60'000};
  CancelToken cancel = {};
  TraceContext trace = {};  ///< trace to which the call belongs; empty: none
};

/// Client side of one call with a deadline. While a function waits for the peer, it polls the
/// cancel token. If the token is cancelled, the function cancels the call, so that the peer stops
/// as well. For use by one thread.
class ClientCall {
 public:
  explicit ClientCall(const ClientCallOptions& options);
  ~ClientCall();
  ClientCall(const ClientCall&) = delete;
  ClientCall& operator=(const ClientCall&) = delete;

  grpc::ClientContext* context() { return &context_; }
  grpc::CompletionQueue* queue() { return &queue_; }

  /// Waits until the running operation has completed. Returns true if the operation succeeded.
  /// REQUIRES: exactly one operation is running.
  bool Await() { return AwaitAny().ok; }

  /// Operation that has completed.
  struct Done {
    void* tag = nullptr;
    bool ok = false;  ///< true if the operation succeeded
  };
  /// Waits until one of the running operations has completed, and returns this operation.
  Done AwaitAny();

  /// Returns the result of the call. `status`: the status from gRPC. The result is Cancelled only
  /// if the caller's own token has cancelled the call. If the peer has cancelled the call, the
  /// result is Unavailable.
  absl::Status Outcome(const grpc::Status& status) const;

 private:
  void CancelIfUnwanted();

  const CancelToken cancel_;
  grpc::ClientContext context_;
  grpc::CompletionQueue queue_;
  bool cancelled_ = false;
};

/// Calls a method with one request and one response. Example:
///   UnaryCall(options, request, &response, [&](auto... a) { return stub->AsyncFrameProgram(a...);
///   })
template <typename Request, typename Response, typename Start>
absl::Status UnaryCall(const ClientCallOptions& options, const Request& request, Response* response,
                       const Start& start) {
  ClientCall call(options);
  grpc::Status status;
  const std::unique_ptr<grpc::ClientAsyncResponseReader<Response>> reader =
      start(call.context(), request, call.queue());
  reader->Finish(response, &status, nullptr);
  call.Await();
  return call.Outcome(status);
}

/// Call of a method with streams in both directions, used by one thread that first writes all
/// requests and then reads all answers.
template <typename Request, typename Response>
class StreamCall {
 public:
  using Stream = grpc::ClientAsyncReaderWriter<Request, Response>;
  using Start =
      std::function<std::unique_ptr<Stream>(grpc::ClientContext*, grpc::CompletionQueue*)>;

  /// Starts the call. `start`: function that calls the stub's PrepareAsync method with the given
  /// context and queue.
  StreamCall(const ClientCallOptions& options, const Start& start)
      : call_(options), stream_(start(call_.context(), call_.queue())) {
    stream_->StartCall(nullptr);
    alive_ = call_.Await();
  }

  ~StreamCall() {
    if (finished_) return;
    call_.context()->TryCancel();
    (void)Finish();
  }

  // gRPC collects the written requests in a buffer; WritesDone sends the remaining bytes. See
  // server_stream.h.

  /// Returns false after an operation has failed because the call has ended. Then Finish returns
  /// the cause.
  bool alive() const { return alive_; }

  /// Writes a request. Returns true if the call is still alive.
  bool Write(const Request& request) {
    return Step([&] { stream_->Write(request, grpc::WriteOptions().set_buffer_hint(), nullptr); });
  }
  /// Ends the requests. Returns true if the call is still alive.
  bool WritesDone() {
    return Step([&] { stream_->WritesDone(nullptr); });
  }
  /// Reads an answer. Returns false if there are no more answers.
  bool Read(Response* response) {
    return Step([&] { stream_->Read(response, nullptr); });
  }

  /// Ends the call and returns its status. Call it once: after the last answer, or to give up.
  absl::Status Finish() {
    finished_ = true;
    grpc::Status status;
    stream_->Finish(&status, nullptr);
    call_.Await();
    return call_.Outcome(status);
  }

  /// Cancels the call, because its answer is no longer needed, and returns `why`.
  absl::Status Abandon(absl::Status why) {
    call_.context()->TryCancel();
    (void)Finish();
    return why;
  }

 private:
  template <typename Operation>
  bool Step(const Operation& operation) {
    if (!alive_) return false;
    operation();
    alive_ = call_.Await();
    return alive_;
  }

  ClientCall call_;
  std::unique_ptr<Stream> stream_;
  bool alive_ = false;
  bool finished_ = false;
};

}  // namespace slicefarm::rpc
