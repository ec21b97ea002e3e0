#pragma once

#include <grpcpp/grpcpp.h>
#include <grpcpp/security/server_credentials.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/limits.h"
#include "common/rpc/observe/call_metrics.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/server/call_queue.h"

namespace slicefarm::rpc {

struct ServerOptions {
  std::string listen = "127.0.0.1:0";  ///< host:port; port 0: any that is free
  int64_t max_message_bytes = limits::kMaxStageMessageBytes;
  int64_t max_buffer_bytes = int64_t{1} << 30;  ///< of messages in flight, over all calls
  int max_threads = 64;  ///< calls beyond are refused with RESOURCE_EXHAUSTED
  /// After which a connection takes no new calls, so that clients spread over new replicas. Calls
  /// that are open go on. 0: never.
  std::chrono::seconds max_connection_age{0};
  /// Calls that one connection may have open; more wait in the client. 0: any number.
  int max_streams_per_connection = 0;
  std::shared_ptr<grpc::ServerCredentials> credentials = nullptr;  ///< null: no TLS
  std::optional<JsonLog> log = {};  ///< of errors of storage, which are not for clients
  /// Of the server's own kind; what they see is what clients are told.
  std::vector<
      std::function<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>()>>
      interceptors = {};
};

/// A gRPC server with health checking, reflection, limits, keepalive and metrics.
class Server {
 public:
  /// `services`, with those of `queued`, and `metrics` must outlive the server. Errors: Unavailable
  /// if it cannot listen there; OUT_OF_RANGE if that is no port.
  static absl::StatusOr<std::unique_ptr<Server>> Start(const ServerOptions& options,
                                                       const std::vector<grpc::Service*>& services,
                                                       CallMetrics& metrics,
                                                       QueuedMethods* queued = nullptr);
  ~Server();

  int port() const { return port_; }

  /// What health says of the server as a whole, and not of its build; until TurnAway.
  void SetReady(bool ready);

  /// Health turns to NOT_SERVING, so that balancers send new calls elsewhere; those that come are
  /// still taken.
  void TurnAway();

  /// TurnAway, and no new call is taken; waits until those in flight are done, and
  /// cancels what is left after `patience`.
  void Drain(std::chrono::milliseconds patience);

 private:
  Server(std::unique_ptr<grpc::Server> server, std::unique_ptr<CallQueue> queue, int port)
      : server_(std::move(server)), queue_(std::move(queue)), port_(port) {}

  std::unique_ptr<grpc::Server> server_;
  std::unique_ptr<CallQueue> queue_;  ///< null if nothing is served from one
  const int port_;
};

}  // namespace slicefarm::rpc
