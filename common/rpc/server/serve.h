#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/observe/call_metrics.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/observe/library_log.h"
#include "common/rpc/observe/metrics.h"
#include "common/rpc/security/authorizer.h"
#include "common/rpc/security/tls.h"
#include "common/rpc/server/call_limiter.h"
#include "common/rpc/server/server.h"
#include "common/rpc/server/shutdown_signal.h"

namespace CLI {
class App;
}

namespace slicefarm::rpc {

/// Command-line options that every server program has.
struct ServeFlags {
  ServerOptions server;
  int metrics_port = -1;  ///< port of the metrics; -1: no metrics; 0: any free port
  /// number of calls that work at the same time; 0: the number of available CPUs
  int max_concurrent = 0;
  int drain_s = 30;
  /// Time in s after which the server ends if it accepts no new connections (AcceptWatch); 0: no
  /// check.
  int accept_patience_s = 30;
  TlsFiles tls;  ///< certificate, key and CAs of the server; all three, or none for no TLS
  ClientCerts client_certs = ClientCerts::kRequired;
  /// Policy that decides which caller may call which method (AuthzPolicy). Only used with TLS.
  std::string_view policy = InnerPolicy();
  std::string policy_file;  ///< file with the policy; empty: `policy` is used
};

/// Exit code of a server that no longer accepts new connections. A restart solves the problem.
inline constexpr int kTakesNoConnections = 3;

/// Adds --listen, --metrics-port, --drain, --accept-patience, --tls-cert, --tls-key, --tls-ca,
/// --authz-policy, and --version.
void AddServeFlags(CLI::App& app, ServeFlags* flags);

/// Life cycle of a server program: serve until SIGTERM or SIGINT, drain, return. Create the object
/// in main() before any thread starts. As soon as the servers listen, the program prints `listening
/// on HOST:PORT` and `metrics on HOST:PORT` to stdout.
class ServerProgram {
 public:
  /// Creates the program. `name`: name for the log, for example `beading` for slicefarm-beading.
  explicit ServerProgram(std::string name) : log_(name), call_metrics_(metrics_.registry()) {
    LogLibrariesTo(log_);
  }

  const JsonLog& log() const { return log_; }
  Metrics& metrics() { return metrics_; }

  /// Waits for SIGTERM or SIGINT. Returns true if a signal arrives within `time`; then the program
  /// must end without calling Run.
  bool EndsWithin(std::chrono::milliseconds time) const { return signal_.WaitFor(time); }

  /// Returns the options of the CallLimiter for calls with heavy work, according to the flags.
  CallLimiterOptions GateOptions(const ServeFlags& flags) const;

  /// Adds the load metrics of `gate` (LimiterMetrics). `gate` must exist until Run returns.
  void Show(const CallLimiter& gate);

  /// Adds the metrics of `cache` (SharedMetrics). `cache` must exist until Run returns.
  void Show(const SharedCache& cache);

  /// Sets a readiness check. While `ready` returns false, the health service reports NOT_SERVING,
  /// but calls are still accepted. During Run, another thread calls `ready` twice per second. Call
  /// this function before Run.
  void ReadyWhile(std::function<bool()> ready) { ready_ = std::move(ready); }

  /// Serves `services`, which include the service of `queued`, until a signal arrives or new
  /// connections are no longer accepted. Then calls `on_signal`, which must end everything that
  /// would keep calls in flight. After Run returns, services and shown metrics are no longer used.
  /// Returns the exit code of the program: 0; 1 if the server cannot listen or cannot use the
  /// certificates; or kTakesNoConnections.
  int Run(const ServeFlags& flags, const std::vector<grpc::Service*>& services,
          const std::function<void()>& on_signal = {}, QueuedMethods* queued = nullptr);

 private:
  absl::StatusOr<std::shared_ptr<grpc::ServerCredentials>> Credentials(
      const ServeFlags& flags) const;
  void ReportReadiness(Server& server, const std::stop_token& stop) const;

  ShutdownSignal signal_;
  JsonLog log_;
  Metrics metrics_;
  CallMetrics call_metrics_;
  std::function<bool()> ready_;  ///< readiness check; null: always ready
};

/// Function that creates a service with the CallLimiter `gate`. `gate` outlives the service.
using MakeService = std::function<std::unique_ptr<grpc::Service>(CallLimiter& gate)>;

/// main() of the server program of one stage.
int ServeStage(int argc, char** argv, const std::string& name, const std::string& about,
               const MakeService& make);

/// Function that creates a service with the CallLimiter `gate`. The service's calls refer to values
/// in `shared` by their digests. `gate` and `shared` outlive the service.
using MakeSharingService =
    std::function<std::unique_ptr<grpc::Service>(CallLimiter& gate, SharedCache& shared)>;

/// main() of the server program of a stage with values that all calls of a job share. The program
/// receives each shared value only once (SharedStore).
int ServeSharingStage(int argc, char** argv, const std::string& name, const std::string& about,
                      const MakeSharingService& make);

}  // namespace slicefarm::rpc
