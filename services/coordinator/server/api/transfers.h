#pragma once

#include <grpcpp/server_context.h>

#include <cstdint>
#include <functional>
#include <string>

#include "absl/status/status.h"
#include "common/rpc/server/stream_watch.h"
#include "services/coordinator/server/api/tenant_places.h"

namespace slicefarm::coordinator {

/// How many uploads (and as many downloads) there may be at once, shared as TenantPlaces says, and
/// how slow each may be.
struct TransferOptions {
  int slots = 64;
  rpc::StreamTimes times = {};
};

/// The way of calls that hold a server thread for as long as their client likes: only so many at
/// once, and none without progress. Thread-safe.
class Transfers {
 public:
  /// To be called for each message, with its bytes.
  using Moved = std::function<void(int64_t bytes)>;

  explicit Transfers(const TransferOptions& options)
      : options_(options), places_(options.slots), watch_(options.times) {}

  /// Does `work` if there is a place. `tenant`: empty where there is only one. Errors: OVERLOADED;
  /// CANCELLED where the call was cut off; those of `work`.
  absl::Status Run(grpc::ServerContext& context, const std::string& tenant,
                   const std::function<absl::Status(const Moved&)>& work);

 private:
  const TransferOptions options_;
  TenantPlaces places_;
  rpc::StreamWatch watch_;
};

}  // namespace slicefarm::coordinator
