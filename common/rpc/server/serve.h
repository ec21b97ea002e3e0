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
#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server.h"
#include "common/rpc/server/shutdown_signal.h"

namespace CLI {
class App;
}

namespace slicefarm::rpc {

/// What every server program can be told on its command line.
struct ServeFlags {
  ServerOptions server;
  int metrics_port = -1;   ///< -1: no metrics are served; 0: any port
  int max_concurrent = 0;  ///< 0: as many as there are CPUs for it
  int drain_s = 30;
  int accept_patience_s = 30;  ///< 0: never asks itself for a connection
  TlsFiles tls;                ///< all three, or none: no TLS
  ClientCerts client_certs = ClientCerts::kRequired;
  std::string_view policy = InnerPolicy();  ///< with TLS: who may call what
  std::string policy_file;                  ///< if not empty, instead of `policy`
};

/// The exit code of a server that took no new connections any more: one that is started anew does.
inline constexpr int kTakesNoConnections = 3;

/// --listen, --metrics-port, --drain, --accept-patience, --tls-cert, --tls-key, --tls-ca,
/// --authz-policy, and
/// --version.
void AddServeFlags(CLI::App& app, ServeFlags* flags);

/// The life of a server program: serve until SIGTERM or SIGINT, drain, return. Make one in main()
/// before any thread starts. Prints `listening on HOST:PORT` and `metrics on HOST:PORT` to stdout
/// once it serves.
class ServerProgram {
 public:
  /// `name`: `beading` of slicefarm-beading.
  explicit ServerProgram(std::string name) : log_(name), call_metrics_(metrics_.registry()) {
    LogLibrariesTo(log_);
  }

  const JsonLog& log() const { return log_; }
  Metrics& metrics() { return metrics_; }

  /// False: there was no signal to end for so long. True: there was, and Run is not to be called.
  bool EndsWithin(std::chrono::milliseconds time) const { return signal_.WaitFor(time); }

  /// The gate for heavy calls that the flags ask for.
  CallGateOptions GateOptions(const ServeFlags& flags) const;

  /// Shows how busy the service behind the gate is. The gate outlives Run.
  void Show(const CallGate& gate);

  /// Shows what is kept of jobs' calls. The cache outlives Run.
  void Show(const SharedCache& cache);

  /// While `ready` returns false, health says NOT_SERVING, and calls are taken all the same. It is
  /// asked twice a second, by a thread that ends with Run. Before Run.
  void ReadyWhile(std::function<bool()> ready) { ready_ = std::move(ready); }

  /// Serves `services`, among them that of `queued`, until a signal comes or no new connection is
  /// taken any more; then calls `on_signal`, which ends what would otherwise keep calls in flight.
  /// When it returns, neither services nor shown metrics are used any more. Returns the exit code
  /// of the program: 0, 1 if it cannot listen, or not with these certificates, or
  /// kTakesNoConnections.
  int Run(const ServeFlags& flags, const std::vector<grpc::Service*>& services,
          const std::function<void()>& on_signal = {}, QueuedMethods* queued = nullptr);

 private:
  absl::StatusOr<std::shared_ptr<grpc::ServerCredentials>> Credentials(
      const ServeFlags& flags) const;
  void TellReadiness(Server& server, const std::stop_token& stop) const;

  ShutdownSignal signal_;
  JsonLog log_;
  Metrics metrics_;
  CallMetrics call_metrics_;
  std::function<bool()> ready_;  ///< null: always
};

/// Makes a service behind a gate, which outlives it.
using MakeService = std::function<std::unique_ptr<grpc::Service>(CallGate& gate)>;

/// main() of the server program of one stage.
int ServeStage(int argc, char** argv, const std::string& name, const std::string& about,
               const MakeService& make);

/// Makes a service behind a gate, whose calls name what is kept in `shared`; both outlive it.
using MakeSharingService =
    std::function<std::unique_ptr<grpc::Service>(CallGate& gate, SharedCache& shared)>;

/// main() of the server program of one stage, where what the calls of a job have in common is sent
/// once (SharedKeeper).
int ServeSharingStage(int argc, char** argv, const std::string& name, const std::string& about,
                      const MakeSharingService& make);

}  // namespace slicefarm::rpc
