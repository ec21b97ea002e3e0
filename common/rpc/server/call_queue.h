#pragma once

#include <grpcpp/grpcpp.h>

#include <functional>
#include <memory>
#include <thread>

namespace slicefarm::rpc {

/// Tag of an operation in the queue. Each asynchronous operation of gRPC gets a pointer to a tag.
/// The tag is called when the operation has ended. `ok`: gRPC's result of the operation.
using QueueTag = std::function<void(bool ok)>;

/// Queue for a thousand or more calls that may stay open for long without occupying a thread. It
/// uses gRPC's asynchronous API, with one thread for all events of these calls.
///
/// gRPC's callback API is unsuitable: in version 1.51 its threads sleep for 0.1 s after each second
/// without a callback. If a server has one method of this kind, it accepts no calls of any method
/// during this sleep. Every eleventh call waited for up to 0.1 s.
class CallQueue {
 public:
  /// REQUIRES: the server has not started yet.
  explicit CallQueue(grpc::ServerBuilder& builder);
  /// Handles the remaining events of the queue's calls. REQUIRES: the server was shut down.
  ~CallQueue();

  grpc::ServerCompletionQueue& queue() { return *queue_; }

 private:
  void Run();

  const std::unique_ptr<grpc::ServerCompletionQueue> queue_;
  std::thread thread_;
};

/// Methods that are served from a CallQueue.
class QueuedMethods {
 public:
  virtual ~QueuedMethods() = default;

  /// Requests the first calls, after the server has started. The tags of all operations on `queue`
  /// are called on one thread, which is not the calling thread.
  virtual void ServeFrom(grpc::ServerCompletionQueue& queue) = 0;
};

}  // namespace slicefarm::rpc
