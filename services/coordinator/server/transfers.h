#pragma once

#include <grpcpp/server_context.h>

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "absl/status/status.h"
#include "common/rpc/admission.h"
#include "common/rpc/stream_watch.h"

namespace slicefarm::coordinator {

/// How many uploads (and as many downloads) there may be at once, and how long each may stand
/// still.
struct TransferOptions {
  int slots = 64;
  int queue = 16;
  int slots_a_tenant = 48;  ///< so that there are some for the others; none of its waits
  rpc::StreamTimes times = {};
};

/// The way of calls that hold a server thread for as long as their client likes: only so many at
/// once, and none without progress. Thread-safe.
class Transfers {
 public:
  /// To be called for each message that brought something.
  using Moved = std::function<void()>;

  explicit Transfers(const TransferOptions& options)
      : options_(options), admission_(options.slots, options.queue), watch_(options.times) {}

  /// Does `work` when its turn has come. `tenant`: empty where there is only one. Errors:
  /// OVERLOADED; DEADLINE_EXCEEDED where the call was cut off; those of `work`.
  absl::Status Run(grpc::ServerContext& context, const std::string& tenant,
                   const std::function<absl::Status(const Moved&)>& work);

 private:
  rpc::Admission& PlacesOf(const std::string& tenant);

  const TransferOptions options_;
  rpc::Admission admission_;
  std::mutex mutex_;
  std::map<std::string, rpc::Admission> by_tenant_;
  rpc::StreamWatch watch_;
};

}  // namespace slicefarm::coordinator
