#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "absl/status/status.h"
#include "common/rpc/client/client_call.h"

namespace slicefarm::rpc {

/// A call of a method with streams both ways whose server answers while it is still being written
/// to: used by one thread, which takes what has come whenever it waits. So neither side waits for
/// the other to read first, whatever the sizes of both streams are.
template <typename Request, typename Response>
class DuplexCall {
 public:
  using Stream = grpc::ClientAsyncReaderWriter<Request, Response>;
  using Start =
      std::function<std::unique_ptr<Stream>(grpc::ClientContext*, grpc::CompletionQueue*)>;
  using Take = std::function<absl::Status(Response&)>;

  /// `start`: the stub's PrepareAsync method. `take` gets each answer, in order, from within Write
  /// and Finish, and may move from it; its first error ends the call.
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

  /// False once the call is over, or an answer was refused: Finish says why.
  bool alive() const { return can_write_; }

  /// Whether the call is still alive.
  bool Write(const Request& request) {
    if (!can_write_) return false;
    writing_ = true;
    stream_->Write(request, grpc::WriteOptions().set_buffer_hint(), &writing_);
    AwaitWritten();
    return can_write_;
  }

  /// Takes the rest of the answers. The first error of `take`, else the call's own.
  absl::Status Finish() {
    if (can_write_) {
      writing_ = true;
      stream_->WritesDone(&writing_);
      AwaitWritten();
    }
    while (reading_) AwaitOne();
    return End();
  }

  /// Ends a call whose answer is of no use any more, and says why.
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
    if (!done.ok) return;  // that was the last answer
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
  bool writing_ = false;  ///< whether an operation is under way; its address is that one's tag
  bool reading_ = false;
  bool can_write_ = false;
  bool finished_ = false;
};

}  // namespace slicefarm::rpc
