#pragma once

#include <grpcpp/server_context.h>

#include <functional>
#include <string>

#include "absl/status/status.h"
#include "common/rpc/server/admission.h"
#include "common/rpc/server/stream_watch.h"
#include "services/coordinator/server/api/tenant_places.h"

namespace slicefarm::coordinator {

/// How many uploads (and as many downloads) there may be at once, and how long each may stand
/// still.
struct TransferOptions {
  int slots = 64;
  int queue = 16;
  int slots_a_tenant = 48;
  rpc::StreamTimes times = {};
};

/// The way of calls that hold a server thread for as long as their client likes: only so many at
/// once, and none without progress. Thread-safe.
class Transfers {
 public:
  /// To be called for each message that brought something.
  using Moved = std::function<void()>;

  explicit Transfers(const TransferOptions& options)
      : options_(options),
        of_tenants_(options.slots + options.queue, options.slots_a_tenant),
        admission_(options.slots, options.queue),
        watch_(options.times) {}

  /// Does `work` when its turn has come. `tenant`: empty where there is only one. Errors:
  /// OVERLOADED; CANCELLED where the call was cut off; those of `work`.
  absl::Status Run(grpc::ServerContext& context, const std::string& tenant,
                   const std::function<absl::Status(const Moved&)>& work);

 private:
  const TransferOptions options_;
  TenantPlaces of_tenants_;
  rpc::Admission admission_;
  rpc::StreamWatch watch_;
};

}  // namespace slicefarm::coordinator
