#include "tests/sim/claim_order.h"

#include <fmt/format.h>

#include <tuple>

namespace slicefarm::coordinator::sim {
namespace {

bool ComesBefore(const JobRecord& a, const JobRecord& b) {
  if (a.priority != b.priority) return a.priority > b.priority;
  return std::tie(a.deadline_us, a.number) < std::tie(b.deadline_us, b.number);
}

std::string Describe(const JobRecord& job) { return fmt::format("{} of {}", job.id, job.tenant); }

}  // namespace

void ClaimOrder::Before(const std::map<int64_t, MemoryJobs::Entry>& jobs, const Call& call) {
  tenants_.clear();
  std::set<std::string> work;  // work that is held
  for (const auto& [number, entry] : jobs) {
    const JobRecord& job = entry.job;
    const bool held = job.owner_until_us > call.now_us && !job.owner.empty();
    if (held && !job.cancel_requested) work.insert(job.action_digest);
  }
  for (const auto& [number, entry] : jobs) {
    const JobRecord& job = entry.job;
    if (IsTerminal(job.state)) continue;
    Tenant& tenant = tenants_[job.tenant];
    if (job.owner_until_us > call.now_us) {
      if (!job.owner.empty()) ++tenant.held;
      continue;
    }
    const bool waits = work.contains(job.action_digest) && !job.cancel_requested;
    if (waits || job.priority < call.filter.at_least) continue;
    if (!tenant.next || ComesBefore(job, *tenant.next)) tenant.next = job;
  }
  if (!call.filter.of_idle_tenants) return;
  for (auto& [name, tenant] : tenants_)
    if (tenant.held > 0) tenant.next.reset();
}

const ClaimOrder::Tenant* ClaimOrder::First() const {
  const Tenant* first = nullptr;
  std::tuple<int64_t, int64_t> first_turn;
  for (const auto& [name, tenant] : tenants_) {  // equal tenants are ordered by name
    if (!tenant.next) continue;
    const auto turn = turns_us_.find(name);
    const std::tuple its_turn(tenant.held, turn == turns_us_.end() ? 0 : turn->second);
    if (first && its_turn >= first_turn) continue;
    first = &tenant;
    first_turn = its_turn;
  }
  return first;
}

std::optional<std::string> ClaimOrder::After(const Call& call, const JobRecord* claimed) {
  const Tenant* first = First();
  if (!claimed) {
    if (!first) return std::nullopt;
    return fmt::format("nothing is claimed, and it is the turn of {}", Describe(*first->next));
  }
  if (!first) return fmt::format("{} is claimed, which it may not be", Describe(*claimed));
  if (first->next->id != claimed->id) {
    return fmt::format("{} is claimed, and it is the turn of {}", Describe(*claimed),
                       Describe(*first->next));
  }
  turns_us_[claimed->tenant] = call.now_us;
  return CheckPassedOver(call, claimed->tenant);
}

/// Checks that no tenant is passed over too often. This follows from the order if the clocks of the
/// claimers agree and their claims arrive in order: a tenant that was served is behind a waiting
/// tenant from then on.
std::optional<std::string> ClaimOrder::CheckPassedOver(const Call& call, const std::string& taken) {
  const bool in_order = call.now_us > latest_us_;
  if (!in_order) {
    passed_over_.clear();
    return std::nullopt;
  }
  latest_us_ = call.now_us;
  passed_over_[taken] = 0;
  for (const auto& [name, tenant] : tenants_) {
    if (name == taken || !tenant.next || tenant.held > 0) continue;
    if (++passed_over_[name] > turns_us_.size()) {
      return fmt::format("{} is passed over {} times", name, passed_over_[name]);
    }
  }
  return std::nullopt;
}

}  // namespace slicefarm::coordinator::sim
