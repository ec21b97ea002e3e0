#pragma once

#include <grpcpp/grpcpp.h>

#include <functional>
#include <memory>
#include <thread>

namespace slicefarm::rpc {

/// What a queue's tags are: gRPC's asynchronous operations take a pointer to one, and it is called
/// when the operation has ended. `ok` means what gRPC says of that operation.
using QueueTag = std::function<void(bool ok)>;

/// Calls that may stay open for long without holding a thread, a thousand of them: gRPC's
/// asynchronous API, with one thread for all that happens to them.
///
/// gRPC has an API of callbacks for that, too. In version 1.51 its threads sleep for 0.1 s after
/// each second without a callback, and a server with one method of that kind takes no call of any
/// other method meanwhile: every eleventh call waited for up to 0.1 s.
class CallQueue {
 public:
  /// To be made before the server starts.
  explicit CallQueue(grpc::ServerBuilder& builder);
  /// REQUIRES: the server was shut down. What its calls still have to hear, they hear now.
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

  /// The server has started: asks for the first calls. Everything that it asks `queue` for happens
  /// on one thread, another than this one.
  virtual void ServeFrom(grpc::ServerCompletionQueue& queue) = 0;
};

}  // namespace slicefarm::rpc
