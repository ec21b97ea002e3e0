#pragma once

#include <chrono>
#include <functional>
#include <memory>
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
  TlsFiles tls;  ///< all three, or none: no TLS
  ClientCerts client_certs = ClientCerts::kRequired;
  std::string_view policy = InnerPolicy();  ///< with TLS: who may call what
  std::string policy_file;                  ///< if not empty, instead of `policy`
};

/// --listen, --metrics-port, --drain, --tls-cert, --tls-key, --tls-ca, --authz-policy, and
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

  /// Serves `services`, among them that of `queued`, until a signal comes; then calls `on_signal`,
  /// which ends what would otherwise keep calls in flight. When it returns, neither services nor
  /// shown metrics are used any more. Returns the exit code of the program: 0, or 1 if it cannot
  /// listen, or not with these certificates.
  int Run(const ServeFlags& flags, const std::vector<grpc::Service*>& services,
          const std::function<void()>& on_signal = {}, QueuedMethods* queued = nullptr);

 private:
  absl::StatusOr<std::shared_ptr<grpc::ServerCredentials>> Credentials(
      const ServeFlags& flags) const;

  ShutdownSignal signal_;
  JsonLog log_;
  Metrics metrics_;
  CallMetrics call_metrics_;
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
