#include "services/coordinator/server/api/transfers.h"

#include "common/base/cancel_scope.h"

namespace slicefarm::coordinator {

absl::Status Transfers::Run(grpc::ServerContext& context, const std::string& tenant,
                            const std::function<absl::Status(const Moved&)>& work) {
  const auto slot = slots_.Enter(tenant);
  if (!slot.ok()) return slot.status();
  rpc::StreamWatch::Guard guard(watch_, context);
  const CancelScope scope(CancelToken([&] { return context.IsCancelled(); }));
  return guard.Outcome(work([&](int64_t bytes) { guard.Moved(bytes); }));
}

}  // namespace slicefarm::coordinator
