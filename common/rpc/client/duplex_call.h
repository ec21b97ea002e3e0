#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "absl/status/status.h"
#include "common/rpc/client/client_call.h"

namespace slicefarm::rpc {

/// Call of a method with streams in both directions. The server may answer before all requests are
/// written. While the calling thread waits to write, it handles the answers that arrive. Therefore
/// client and server never both wait until the peer reads, at any length of the streams. For use by
/// one thread.
template <typename Request, typename Response>
class DuplexCall {
 public:
  using Stream = grpc::ClientAsyncReaderWriter<Request, Response>;
  using Start =
      std::function<std::unique_ptr<Stream>(grpc::ClientContext*, grpc::CompletionQueue*)>;
  using Take = std::function<absl::Status(Response&)>;

  /// Starts the call. `start`: function that calls the stub's PrepareAsync method with the given
  /// context and queue. `take`: receives each answer, in order, during Write and Finish, and may
  /// move from it. The first error of `take` ends the call.
  DuplexCall(const ClientCallOptions& options, const Start& start, Take take)
      : call_(options), take_(std::move(take)), stream_(start(call_.context(), call_.queue())) {
    stream_->StartCall(&writing_);
    writing_ = true;
    AwaitWritten();
    if (can_write_) Read();
  }

  ~DuplexCall() {
    if (!finished_) (void)Abandon(absl::OkStatus());
  }

  /// Returns false after the call has ended or `take` has returned an error. Then Finish returns
  /// the cause.
  bool alive() const { return can_write_; }

  /// Writes a request. Returns true if the call is still alive.
  bool Write(const Request& request) {
    if (!can_write_) return false;
    writing_ = true;
    stream_->Write(request, grpc::WriteOptions().set_buffer_hint(), &writing_);
    AwaitWritten();
    return can_write_;
  }

  /// Passes the remaining answers to `take` and ends the call. Returns the first error of `take`;
  /// if there is none, the status of the call.
  absl::Status Finish() {
    if (can_write_) {
      writing_ = true;
      stream_->WritesDone(&writing_);
      AwaitWritten();
    }
    while (reading_) AwaitOne();
    return End();
  }

  /// Cancels the call, because its answer is no longer needed, and returns `why`.
  absl::Status Abandon(absl::Status why) {
    call_.context()->TryCancel();
    while (reading_ || writing_) AwaitOne();
    (void)End();
    return why;
  }

 private:
  void Read() {
    reading_ = true;
    stream_->Read(&response_, &reading_);
  }

  void AwaitWritten() {
    while (writing_) AwaitOne();
  }

  void AwaitOne() {
    const ClientCall::Done done = call_.AwaitAny();
    if (done.tag == &writing_) {
      writing_ = false;
      can_write_ = done.ok && taken_.ok();
      return;
    }
    reading_ = false;
    if (!done.ok) return;  // there are no more answers
    if (taken_.ok()) taken_ = take_(response_);
    if (!taken_.ok()) call_.context()->TryCancel();
    Read();
  }

  absl::Status End() {
    finished_ = true;
    grpc::Status status;
    stream_->Finish(&status, nullptr);
    call_.Await();
    return taken_.ok() ? call_.Outcome(status) : taken_;
  }

  ClientCall call_;
  const Take take_;
  std::unique_ptr<Stream> stream_;
  Response response_;
  absl::Status taken_;
  /// True while a write operation is running. The address of this member is the operation's tag.
  bool writing_ = false;
  bool reading_ = false;
  bool can_write_ = false;
  bool finished_ = false;
};

}  // namespace slicefarm::rpc
