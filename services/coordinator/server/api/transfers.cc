#include "services/coordinator/server/api/transfers.h"

#include "common/rpc/server/call_scope.h"

namespace slicefarm::coordinator {

absl::Status Transfers::Run(grpc::ServerContext& context, const std::string& tenant,
                            const std::function<absl::Status(const Moved&)>& work) {
  const rpc::CallScope scope(context, options_.times.default_deadline);
  const auto place = of_tenants_.Enter(tenant, scope.Token());
  if (!place.ok()) return scope.Outcome(place.status());
  const auto turn = admission_.Enter(scope.Token());
  if (!turn.ok()) return scope.Outcome(turn.status());
  rpc::StreamWatch::Guard guard(watch_, context);
  return guard.Outcome(work([&] { guard.Moved(); }));
}

}  // namespace slicefarm::coordinator
