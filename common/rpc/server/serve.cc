#include "common/rpc/server/serve.h"

#include <fmt/core.h>
#include <grpcpp/impl/service_type.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <optional>

#include "common/base/available_cpus.h"
#include "common/base/build_info.h"
#include "common/base/stoppable_sleep.h"
#include "common/rpc/address/listen_address.h"
#include "common/rpc/observe/shared_metrics.h"
#include "common/rpc/security/certificate_metrics.h"
#include "common/rpc/security/tls_options.h"
#include "common/rpc/server/accept_watch.h"
#include "common/rpc/server/limiter_metrics.h"
#include "common/rpc/server/open_files.h"
#include "common/rpc/server/shared_store.h"
#include "common/rpc/server/stage_command_line.h"

namespace slicefarm::rpc {
namespace {

/// Number of threads in addition to working and waiting calls: for health, reflection and calls
/// that are refused.
constexpr int kSpareThreads = 16;

constexpr std::chrono::milliseconds kAskReadyEvery{500};

/// Returns the address without its port.
std::string HostPart(const std::string& address) { return address.substr(0, address.rfind(':')); }

void Announce(std::string_view what, const std::string& host, int port) {
  fmt::print("{} on {}:{}\n", what, host, port);
  std::fflush(stdout);
}

int Concurrency(const ServeFlags& flags) {
  if (flags.max_concurrent > 0) return flags.max_concurrent;
  return AvailableCpus();
}

/// Reads the command line of a stage's server, and serves.
int Serve(int argc, char** argv, const std::string& name, const std::string& about,
          const std::function<int(ServerProgram&, const ServeFlags&)>& serve) {
  ServerProgram program(name);
  ServeFlags flags;
  StageCommandLine command_line(name, about, &flags);
  command_line.AddConcurrency(&flags);
  if (const auto code = command_line.Parse(argc, argv)) return *code;
  return serve(program, flags);
}

void AddTlsFlags(CLI::App& app, ServeFlags* flags) {
  auto* cert = AddTlsCert(
      app, &flags->tls,
      "TLS certificate of this server, which it also uses as a client; without it, no TLS");
  auto* key = AddTlsKey(app, &flags->tls, "Private key of the certificate");
  auto* ca = AddTlsCa(
      app, &flags->tls,
      "CA certificates that sign the certificates of this server's clients and of other servers");
  cert->needs(key)->needs(ca);
  key->needs(cert)->needs(ca);
  ca->needs(cert)->needs(key);
  app.add_option("--authz-policy", flags->policy_file,
                 "JSON file of the authorization policy: the clients that may call each method. "
                 "Default: the built-in policy")
      ->type_name("FILE")
      ->needs(ca);
}

}  // namespace

void AddServeFlags(CLI::App& app, ServeFlags* flags) {
  app.set_version_flag(
      "--version", fmt::format("slicefarm {} ({}) build {}", Version(), ReleaseDate(), BuildId()));
  app.add_option("--listen", flags->server.listen, "Address to serve on; port 0: any free port")
      ->capture_default_str();
  app.add_option("--metrics-port", flags->metrics_port,
                 "Port for Prometheus (/metrics) and status pages; 0: any free port, -1: none")
      ->check(CLI::Range(-1, 65535))
      ->capture_default_str();
  app.add_option("--drain", flags->drain_s,
                 "Seconds that running calls have after SIGTERM to finish")
      ->check(CLI::Range(0, 3600))
      ->capture_default_str();
  app.add_option("--accept-patience", flags->accept_patience_s,
                 "Seconds after which a server that can no longer accept connections ends with "
                 "exit code 3, so that it is restarted; 0: never")
      ->check(CLI::Range(0, 3600))
      ->capture_default_str();
  AddTlsFlags(app, flags);
}

CallLimiterOptions ServerProgram::GateOptions(const ServeFlags& flags) const {
  CallLimiterOptions options;
  options.slots = Concurrency(flags);
  options.queue = 4 * options.slots;
  return options;
}

void ServerProgram::Show(const CallLimiter& gate) {
  metrics_.Show(std::make_shared<LimiterMetrics>(gate.admission()));
}

void ServerProgram::Show(const SharedCache& cache) {
  metrics_.Show(std::make_shared<SharedMetrics>(cache));
}

/// Returns the credentials of the server; null without TLS.
absl::StatusOr<std::shared_ptr<grpc::ServerCredentials>> ServerProgram::Credentials(
    const ServeFlags& flags) const {
  if (!flags.tls.enabled()) {
    if (!IsLoopback(flags.server.listen)) {
      log_.Warn("served without TLS: everybody who reaches this address may call",
                {{"address", flags.server.listen}});
    }
    return nullptr;
  }
  const auto tls = Tls::Open(flags.tls);
  if (!tls.ok()) return tls.status();
  auto authorizer = flags.policy_file.empty() ? Authorizer::Make(flags.policy, log_)
                                              : Authorizer::Watch(flags.policy_file, log_);
  if (!authorizer.ok()) return authorizer.status();
  auto credentials = (*tls)->ForServer(flags.client_certs);
  credentials->SetAuthMetadataProcessor(*std::move(authorizer));
  return credentials;
}

void ServerProgram::ReportReadiness(Server& server, const std::stop_token& stop) const {
  bool reported = true;
  while (SleepUnlessStopped(stop, kAskReadyEvery)) {
    const bool ready = ready_();
    if (ready == reported) continue;
    server.SetReady(ready);
    ready ? log_.Info("ready again") : log_.Warn("not ready: the store does not answer");
    reported = ready;
  }
}

int ServerProgram::Run(const ServeFlags& flags, const std::vector<grpc::Service*>& services,
                       const std::function<void()>& on_signal, QueuedMethods* queued) {
  RaiseOpenFilesLimit();
  ServerOptions options = flags.server;
  const CallLimiterOptions gate = GateOptions(flags);
  options.max_threads = std::max(options.max_threads, gate.slots + gate.queue + kSpareThreads);
  auto credentials = Credentials(flags);
  if (!credentials.ok()) {
    log_.Error("cannot serve", {{"error", std::string(credentials.status().message())}});
    return 1;
  }
  options.credentials = *std::move(credentials);
  options.log = log_;
  if (flags.tls.has_certificate()) metrics_.Show(std::make_shared<CertificateMetrics>(flags.tls));
  absl::StatusOr<std::unique_ptr<Server>> server =
      Server::Start(options, services, call_metrics_, queued);
  if (!server.ok()) {
    log_.Error("cannot serve", {{"error", std::string(server.status().message())}});
    return 1;
  }
  const std::string host = HostPart(options.listen);
  if (flags.metrics_port >= 0) {
    const absl::StatusOr<int> port = metrics_.Serve(fmt::format("{}:{}", host, flags.metrics_port));
    if (!port.ok()) {
      log_.Error("cannot serve", {{"error", std::string(port.status().message())}});
      return 1;
    }
    Announce("metrics", host, *port);
  }
  Announce("listening", host, (*server)->port());
  log_.Info("serving", {{"address", fmt::format("{}:{}", host, (*server)->port())},
                        {"version", std::string(Version())}});

  std::jthread readiness;
  if (ready_)
    readiness = std::jthread([&](const std::stop_token& stop) { ReportReadiness(**server, stop); });
  std::atomic<bool> dead = false;
  std::optional<AcceptWatch> watch;
  if (flags.accept_patience_s > 0) {
    watch.emplace(fmt::format("{}:{}", host, (*server)->port()), flags.tls.enabled(),
                  std::chrono::seconds(flags.accept_patience_s), [&] {
                    log_.Error("no new connections are accepted any more: this process ends");
                    dead = true;
                    kill(getpid(), SIGTERM);
                  });
  }
  const int signal = signal_.Wait();
  watch.reset();
  readiness = {};
  log_.Info("draining", {{"signal", int64_t{signal}}});
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(flags.drain_s);
  (*server)->TurnAway();
  if (on_signal) on_signal();
  (*server)->Drain(
      std::max(std::chrono::milliseconds(0), std::chrono::duration_cast<std::chrono::milliseconds>(
                                                 end - std::chrono::steady_clock::now())));
  metrics_.Stop();  // the shown values may belong to the caller and end with the caller's scope
  log_.Info("stopped");
  return dead ? kTakesNoConnections : 0;
}

int ServeStage(int argc, char** argv, const std::string& name, const std::string& about,
               const MakeService& make) {
  return Serve(argc, argv, name, about, [&](ServerProgram& program, const ServeFlags& flags) {
    CallLimiter gate(program.GateOptions(flags), program.log());
    program.Show(gate);
    const std::unique_ptr<grpc::Service> service = make(gate);
    return program.Run(flags, {service.get()});
  });
}

int ServeSharingStage(int argc, char** argv, const std::string& name, const std::string& about,
                      const MakeSharingService& make) {
  return Serve(argc, argv, name, about, [&](ServerProgram& program, const ServeFlags& flags) {
    SharedStore keeper(program.log());
    program.Show(keeper.cache());
    CallLimiter gate(program.GateOptions(flags), program.log());
    program.Show(gate);
    const std::unique_ptr<grpc::Service> service = make(gate, keeper.cache());
    return program.Run(flags, {service.get(), &keeper.service()});
  });
}

}  // namespace slicefarm::rpc
