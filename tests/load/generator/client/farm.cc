#include "tests/load/generator/client/farm.h"

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/rpc/client/channel.h"

namespace slicefarm::load {

absl::StatusOr<std::unique_ptr<Farm>> Farm::Connect(const std::string& server,
                                                    const rpc::ClientSecurity& security,
                                                    int connections,
                                                    std::chrono::milliseconds patience) {
  const auto options = rpc::Secured({.max_message_bytes = limits::kMaxPublicMessageBytes,
                                     .retries = false,
                                     .own_connection = true},
                                    security, server);
  if (!options.ok()) return options.status();
  const auto deadline = std::chrono::system_clock::now() + patience;
  std::vector<std::unique_ptr<FarmCalls>> calls;
  for (int i = 0; i < connections; ++i) {
    auto channel = rpc::MakeChannel(server, *options);
    if (!channel->WaitForConnected(deadline)) {
      return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                       "no coordinator answers on " + server +
                           (security.tls.enabled() ? ", or not to this certificate" : ""),
                       {{"address", server}});
    }
    calls.push_back(std::make_unique<FarmCalls>(std::move(channel)));
  }
  return std::unique_ptr<Farm>(new Farm(std::move(calls)));
}

}  // namespace slicefarm::load
