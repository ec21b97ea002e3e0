#include "services/load/client/farm.h"

#include "common/model/error.h"
#include "common/model/limits.h"
#include "common/rpc/channel.h"

namespace slicefarm::load {

absl::StatusOr<std::unique_ptr<Farm>> Farm::Connect(const std::string& server, int connections,
                                                    std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::system_clock::now() + patience;
  std::vector<std::unique_ptr<FarmCalls>> calls;
  for (int i = 0; i < connections; ++i) {
    auto channel = rpc::MakeChannel(server, {.max_message_bytes = limits::kMaxPublicMessageBytes,
                                             .retries = false,
                                             .own_connection = true});
    if (!channel->WaitForConnected(deadline)) {
      return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                       "no coordinator answers on " + server, {{"address", server}});
    }
    calls.push_back(std::make_unique<FarmCalls>(std::move(channel)));
  }
  return std::unique_ptr<Farm>(new Farm(std::move(calls)));
}

}  // namespace slicefarm::load
