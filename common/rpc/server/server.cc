#include "common/rpc/server/server.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/resource_quota.h>

#include <utility>

#include "common/base/error.h"
#include "common/rpc/address/listen_address.h"
#include "common/rpc/client/health.h"
#include "common/rpc/server/storage_errors.h"
#include "common/rpc/server/unreadable_request.h"

namespace slicefarm::rpc {
namespace {

void SetLimits(const ServerOptions& options, grpc::ServerBuilder* builder) {
  builder->SetMaxReceiveMessageSize(static_cast<int>(options.max_message_bytes));
  builder->SetMaxSendMessageSize(static_cast<int>(options.max_message_bytes));
  grpc::ResourceQuota quota("slicefarm");
  quota.Resize(static_cast<size_t>(options.max_buffer_bytes));
  quota.SetMaxThreads(options.max_threads);
  builder->SetResourceQuota(quota);
  if (options.max_streams_per_connection > 0) {
    builder->AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS,
                                options.max_streams_per_connection);
  }
}

void SetConnectionRules(const ServerOptions& options, grpc::ServerBuilder* builder) {
  if (options.max_connection_age > std::chrono::seconds(0)) {
    const std::chrono::milliseconds age = options.max_connection_age;
    builder->AddChannelArgument(GRPC_ARG_MAX_CONNECTION_AGE_MS, static_cast<int>(age.count()));
  }
  // Clients ping every 20 s (channel.cc); with default settings, a server treats this as abuse.
  builder->AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 10'000);
  builder->AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  // Detects clients with a machine that is gone, so that their calls are cancelled.
  builder->AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, 20'000);
  builder->AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 10'000);
  // Two servers on one port would each get a share of the calls; the second one must fail instead.
  builder->AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
}

}  // namespace

absl::StatusOr<std::unique_ptr<Server>> Server::Start(const ServerOptions& options,
                                                      const std::vector<grpc::Service*>& services,
                                                      CallMetrics& metrics, QueuedMethods* queued) {
  if (!PortFits(options.listen))
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfRange,
                     "cannot listen on " + options.listen + ": the last port is 65535",
                     {{"address", options.listen}});
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  grpc::ServerBuilder builder;
  int port = 0;
  builder.AddListeningPort(
      options.listen, options.credentials ? options.credentials : grpc::InsecureServerCredentials(),
      &port);
  SetLimits(options, &builder);
  SetConnectionRules(options, &builder);
  for (grpc::Service* service : services) builder.RegisterService(service);
  std::vector<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>> interceptors;
  // Runs before the call is counted.
  interceptors.push_back(std::make_unique<UnreadableRequestFactory>());
  if (options.log) interceptors.push_back(std::make_unique<StorageErrorsFactory>(*options.log));
  interceptors.push_back(std::make_unique<CallMetricsFactory>(metrics));
  for (const auto& make : options.interceptors) interceptors.push_back(make());
  builder.experimental().SetInterceptorCreators(std::move(interceptors));
  auto queue = queued == nullptr ? nullptr : std::make_unique<CallQueue>(builder);
  std::unique_ptr<grpc::Server> server = builder.BuildAndStart();
  if (server == nullptr || port == 0) {
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                     "cannot listen on " + options.listen, {{"address", options.listen}});
  }
  if (auto* health = server->GetHealthCheckService()) {
    health->SetServingStatus(ServiceOfThisBuild(), true);
    health->SetServingStatus(kLiveService, true);
  }
  if (queued != nullptr) queued->ServeFrom(queue->queue());
  return std::unique_ptr<Server>(new Server(std::move(server), std::move(queue), port));
}

Server::~Server() { Drain(std::chrono::milliseconds(0)); }

void Server::SetReady(bool ready) {
  // The empty name means the server as a whole. SetServingStatus without a name would set all
  // services.
  if (auto* health = server_->GetHealthCheckService()) health->SetServingStatus("", ready);
}

void Server::TurnAway() {
  if (auto* health = server_->GetHealthCheckService()) health->Shutdown();
}

void Server::Drain(std::chrono::milliseconds patience) {
  TurnAway();
  server_->Shutdown(std::chrono::system_clock::now() + patience);
  server_->Wait();
  queue_.reset();
}

}  // namespace slicefarm::rpc
