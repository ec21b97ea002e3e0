#include "common/rpc/client/channel.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/support/channel_arguments.h>

#include <utility>
#include <vector>

#include "common/rpc/security/bearer_token.h"

namespace slicefarm::rpc {
namespace {

// Retries are only for unary methods, because a caller that has read part of a stream's answer
// cannot undo this. DeleteJob and DeleteProfile are excluded, because a second attempt would not
// find the object. CreateJob can be retried safely with a request_id.
constexpr char kServiceConfig[] = R"({
  "methodConfig": [{
    "name": [
      {"service": "slicefarm.v1.Motion", "method": "FrameProgram"},
      {"service": "slicefarm.v1.Worker", "method": "GetWorkerInfo"},
      {"service": "slicefarm.v1.Meshes", "method": "GetUpload"},
      {"service": "slicefarm.v1.Jobs", "method": "CreateJob"},
      {"service": "slicefarm.v1.Jobs", "method": "BatchCreateJobs"},
      {"service": "slicefarm.v1.Jobs", "method": "CreatePlates"},
      {"service": "slicefarm.v1.Jobs", "method": "GetJob"},
      {"service": "slicefarm.v1.Jobs", "method": "ListJobs"},
      {"service": "slicefarm.v1.Jobs", "method": "CancelJob"},
      {"service": "slicefarm.v1.Jobs", "method": "GetWebhook"},
      {"service": "slicefarm.v1.Profiles", "method": "PutProfile"},
      {"service": "slicefarm.v1.Profiles", "method": "GetProfile"},
      {"service": "slicefarm.v1.Profiles", "method": "ListProfiles"},
      {"service": "slicefarm.v1.Presets", "method": "ImportPresets"},
      {"service": "slicefarm.v1.Presets", "method": "GetPresetBundle"},
      {"service": "slicefarm.v1.Presets", "method": "ListPresetBundles"},
      {"service": "slicefarm.v1.Presets", "method": "ListPresets"},
      {"service": "slicefarm.v1.Presets", "method": "ResolvePresets"}
    ],
    "retryPolicy": {
      "maxAttempts": 4,
      "initialBackoff": "0.02s",
      "maxBackoff": "0.5s",
      "backoffMultiplier": 4,
      "retryableStatusCodes": ["UNAVAILABLE"]
    }
  }],
  "retryThrottling": {"maxTokens": 10, "tokenRatio": 0.1}
})";

}  // namespace

std::shared_ptr<grpc::Channel> MakeChannel(const std::string& address,
                                           const ChannelOptions& options) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(static_cast<int>(options.max_message_bytes));
  arguments.SetMaxSendMessageSize(static_cast<int>(options.max_message_bytes));
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, 20'000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 10'000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  arguments.SetInt(GRPC_ARG_HTTP2_MAX_PINGS_WITHOUT_DATA, 0);
  // gRPC's default backoff grows to two minutes, but a restarted stage is available again within a
  // second.
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 100);
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 1'000);
  // This value is also the time limit of one connection attempt. An address without a running
  // machine does not answer at all.
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, 1'000);
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  arguments.SetInt(GRPC_ARG_SERVICE_CONFIG_DISABLE_RESOLUTION, 1);
  arguments.SetServiceConfigJSON(kServiceConfig);
  arguments.SetInt(GRPC_ARG_ENABLE_RETRIES, options.retries ? 1 : 0);
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, options.own_connection ? 1 : 0);
  if (!options.server_name.empty()) arguments.SetSslTargetNameOverride(options.server_name);
  std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> interceptors;
  if (!options.token.empty()) {
    interceptors.push_back(std::make_unique<BearerTokenFactory>(options.token));
  }
  return grpc::experimental::CreateCustomChannelWithInterceptors(
      address, options.credentials ? options.credentials : grpc::InsecureChannelCredentials(),
      arguments, std::move(interceptors));
}

}  // namespace slicefarm::rpc
