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

/// Address, limits, security and logging of a server.
struct ServerOptions {
  std::string listen = "127.0.0.1:0";  ///< host:port; port 0: any free port
  int64_t max_message_bytes = limits::kMaxStageMessageBytes;
  int64_t max_buffer_bytes = int64_t{1} << 30;  ///< limit on messages in flight, over all calls
  /// Largest number of threads, which is also the largest number of calls at the same time; further
  /// calls are refused with RESOURCE_EXHAUSTED. Calls of a CallQueue do not count.
  int max_threads = 64;
  /// Age after which a connection accepts no new calls. Its client then connects again, and may
  /// reach a new replica. Open calls continue. 0: no limit.
  std::chrono::seconds max_connection_age{0};
  /// Largest number of open calls per connection; further calls wait in the client. 0: no limit.
  int max_streams_per_connection = 0;
  std::shared_ptr<grpc::ServerCredentials> credentials = nullptr;  ///< null: no TLS
  /// Log for the details of storage errors, which clients must not see (StorageErrorsFactory).
  /// nullopt: the details are not hidden.
  std::optional<JsonLog> log = {};
  /// Additional interceptors. They receive each status in the form in which the client receives it.
  std::vector<
      std::function<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>()>>
      interceptors = {};
};

/// gRPC server with health checking, reflection, limits, keepalive and metrics.
class Server {
 public:
  /// Starts a server. `services`, the service of `queued`, and `metrics` must outlive the server.
  /// Errors: Unavailable if the server cannot listen on the address; OUT_OF_RANGE if the port is
  /// invalid.
  static absl::StatusOr<std::unique_ptr<Server>> Start(const ServerOptions& options,
                                                       const std::vector<grpc::Service*>& services,
                                                       CallMetrics& metrics,
                                                       QueuedMethods* queued = nullptr);
  ~Server();

  int port() const { return port_; }

  /// Sets the health of the whole server. The health of ServiceOfThisBuild does not change. Has no
  /// effect after TurnAway.
  void SetReady(bool ready);

  /// Sets the health of all services to NOT_SERVING, so that load balancers send new calls to other
  /// servers. The server still accepts calls.
  void TurnAway();

  /// Calls TurnAway and accepts no new calls. Waits until the calls in flight have ended, and
  /// cancels the remaining ones after `patience`.
  void Drain(std::chrono::milliseconds patience);

 private:
  Server(std::unique_ptr<grpc::Server> server, std::unique_ptr<CallQueue> queue, int port)
      : server_(std::move(server)), queue_(std::move(queue)), port_(port) {}

  std::unique_ptr<grpc::Server> server_;
  std::unique_ptr<CallQueue> queue_;  ///< null if no methods are served from a queue
  const int port_;
};

}  // namespace slicefarm::rpc
