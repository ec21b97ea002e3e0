#pragma once

#include <grpcpp/grpcpp.h>

#include <functional>
#include <memory>
#include <thread>

namespace slicefarm::rpc {

/// Tag of an asynchronous operation of gRPC in the queue. gRPC gets a pointer to the tag. When the
/// operation has ended, the queue calls the tag. `ok`: gRPC's result of the operation.
using QueueTag = std::function<void(bool ok)>;

/// Queue for a thousand or more calls that may remain open for long without occupying a thread. It
/// uses gRPC's asynchronous API, with one thread for all events of these calls.
///
/// gRPC's callback API is unsuitable: in version 1.51 its threads sleep for 0.1 s after each second
/// without a callback. If a server has one method of the callback API, it accepts no calls of any
/// method during this sleep. Every eleventh call waited for up to 0.1 s.
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
