#include "services/coordinator/server/transfers.h"

#include "common/rpc/call_scope.h"

namespace slicefarm::coordinator {

rpc::Admission& Transfers::PlacesOf(const std::string& tenant) {
  const int slots = tenant.empty() ? options_.slots : options_.slots_a_tenant;
  const std::lock_guard lock(mutex_);
  return by_tenant_.try_emplace(tenant, slots, tenant.empty() ? options_.queue : 0).first->second;
}

absl::Status Transfers::Run(grpc::ServerContext& context, const std::string& tenant,
                            const std::function<absl::Status(const Moved&)>& work) {
  const rpc::CallScope scope(context, options_.times.default_deadline);
  const auto place = PlacesOf(tenant).Enter(scope.Token());
  if (!place.ok()) return scope.Outcome(place.status());
  const auto turn = admission_.Enter(scope.Token());
  if (!turn.ok()) return scope.Outcome(turn.status());
  rpc::StreamWatch::Guard guard(watch_, context);
  return guard.Outcome(work([&] { guard.Moved(); }));
}

}  // namespace slicefarm::coordinator
