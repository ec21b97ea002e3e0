#pragma once

#include <grpcpp/server_context.h>

#include <cstdint>
#include <functional>
#include <string>

#include "absl/status/status.h"
#include "common/rpc/server/stream_watch.h"
#include "services/coordinator/server/api/tenant_slots.h"

namespace slicefarm::coordinator {

/// Limits of transfers: largest number of simultaneous uploads (and of downloads), which tenants
/// share by the rule of TenantSlots, and slowest allowed transfer.
struct TransferOptions {
  int slots = 64;
  rpc::StreamTimes times = {};
};

/// Limits calls that occupy a server thread for as long as their client sends or receives. Limits
/// the number of these calls, and cuts off calls that are slower than the options allow.
/// Thread-safe.
class Transfers {
 public:
  /// Function that must be called for each message, with its number of bytes.
  using Moved = std::function<void(int64_t bytes)>;

  explicit Transfers(const TransferOptions& options)
      : options_(options), slots_(options.slots), watch_(options.times) {}

  /// Runs `work` if a slot is free. `tenant`: empty if there is only one. Errors: OVERLOADED;
  /// CANCELLED if the call was cut off; errors of `work`.
  absl::Status Run(grpc::ServerContext& context, const std::string& tenant,
                   const std::function<absl::Status(const Moved&)>& work);

 private:
  const TransferOptions options_;
  TenantSlots slots_;
  rpc::StreamWatch watch_;
};

}  // namespace slicefarm::coordinator
