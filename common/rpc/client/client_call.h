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

struct ClientCallOptions {
  std::chrono::milliseconds deadline{60'000};
  CancelToken cancel = {};
  TraceContext trace = {};  ///< empty: the call belongs to none
};

/// One call from the caller's side: its deadline is always set, and while it waits for the peer it
/// asks the cancel token and cancels the call, so that the peer stops as well. For one thread.
class ClientCall {
 public:
  explicit ClientCall(const ClientCallOptions& options);
  ~ClientCall();
  ClientCall(const ClientCall&) = delete;
  ClientCall& operator=(const ClientCall&) = delete;

  grpc::ClientContext* context() { return &context_; }
  grpc::CompletionQueue* queue() { return &queue_; }

  /// Waits for the operation that was started last; true if it went well.
  bool Await() { return AwaitAny().ok; }

  struct Done {
    void* tag = nullptr;
    bool ok = false;  ///< whether it went well
  };
  /// Waits for one of the operations that are under way.
  Done AwaitAny();

  /// What the call came to, `status` being gRPC's word: Cancelled if our own token asked for it; a
  /// peer that gave up by itself is Unavailable.
  absl::Status Outcome(const grpc::Status& status) const;

 private:
  void CancelIfUnwanted();

  const CancelToken cancel_;
  grpc::ClientContext context_;
  grpc::CompletionQueue queue_;
  bool cancelled_ = false;
};

/// A call of a method with one request and one response.
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

/// A call of a method with streams both ways, used by one thread: write all, then read all.
template <typename Request, typename Response>
class StreamCall {
 public:
  using Stream = grpc::ClientAsyncReaderWriter<Request, Response>;
  using Start =
      std::function<std::unique_ptr<Stream>(grpc::ClientContext*, grpc::CompletionQueue*)>;

  /// `start`: the stub's PrepareAsync method.
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

  // Writes gather in gRPC's write buffer; WritesDone sends what is left. See server_stream.h.

  /// False once an operation found the call to be over: Finish says why.
  bool alive() const { return alive_; }

  bool Write(const Request& request) {
    return Step([&] { stream_->Write(request, grpc::WriteOptions().set_buffer_hint(), nullptr); });
  }
  bool WritesDone() {
    return Step([&] { stream_->WritesDone(nullptr); });
  }
  bool Read(Response* response) {
    return Step([&] { stream_->Read(response, nullptr); });
  }

  /// The call's end. To be called once, when there is nothing left to read, or to give up.
  absl::Status Finish() {
    finished_ = true;
    grpc::Status status;
    stream_->Finish(&status, nullptr);
    call_.Await();
    return call_.Outcome(status);
  }

  /// Ends a call whose answer is of no use any more, and says why.
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
