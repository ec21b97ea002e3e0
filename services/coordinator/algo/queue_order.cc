#include "services/coordinator/algo/queue_order.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>

namespace slicefarm::coordinator {
namespace {

constexpr size_t kFewestRuns = 3;         ///< fewest finished runs for which a mean is computed
constexpr int64_t kAnyRunUs = 1'000'000;  ///< assumed run time if there is no mean

/// Slot of a coordinator that runs one job at a time.
struct JobSlot {
  int64_t free_us = 0;
  int64_t rank = 0;  ///< order among slots that become free at the same time
  bool for_interactive = false;
  std::string tenant = {};  ///< tenant of the current job, if `taken`
  bool taken = false;

  bool operator>(const JobSlot& other) const {
    return std::tie(free_us, rank) > std::tie(other.free_us, other.rank);
  }
};

using JobSlots = std::priority_queue<JobSlot, std::vector<JobSlot>, std::greater<>>;

/// Returns the time at which a held slot becomes free.
int64_t FreeUs(const HeldSlot& held, int64_t run_us, int64_t now_us) {
  const int64_t elapsed_us = held.start_us == 0 ? 0 : std::max<int64_t>(0, now_us - held.start_us);
  return now_us + (elapsed_us < run_us ? run_us - elapsed_us : elapsed_us);
}

/// Returns the slots of all coordinators that hold a job, and one slot if none does. A
/// coordinator's first interactive job is assumed to use the slot that is reserved for interactive
/// jobs.
JobSlots SlotsOf(const QueueSnapshot& queue, int64_t run_us, int64_t now_us) {
  JobSlots slots;
  int64_t rank = 0;
  std::map<std::string, bool> kept_taken;  // by owner
  for (const HeldSlot& held : queue.held) {
    bool& taken = kept_taken[held.owner];
    const bool kept = held.interactive && !taken;
    taken |= kept;
    slots.push({FreeUs(held, run_us, now_us), rank++, kept, held.tenant, true});
  }
  for (const auto& [owner, taken] : kept_taken)
    if (!taken) slots.push({.free_us = now_us, .rank = rank++, .for_interactive = true});
  if (queue.held.empty()) slots.push({.free_us = now_us});
  return slots;
}

/// Tenants in the order in which their jobs begin next.
class TenantOrder {
 public:
  TenantOrder(const QueueSnapshot& queue, int64_t now_us) : last_turn_us_(now_us) {
    for (const HeldSlot& held : queue.held) ++held_[held.tenant];
    for (const TenantQueue& tenant : queue.tenants) {
      last_turn_us_ = std::max(last_turn_us_, tenant.turn_us);
      if (!tenant.waiting.empty()) Enter({&tenant, tenant.turn_us});
    }
  }

  bool empty() const { return entries_.empty(); }

  /// Records that a job of the tenant has ended.
  void Ended(const std::string& tenant) {
    const auto waiting = entries_.find(tenant);
    if (waiting != entries_.end()) order_.erase({held_[tenant], waiting->second.turn_us, tenant});
    --held_[tenant];
    if (waiting != entries_.end()) order_.insert({held_[tenant], waiting->second.turn_us, tenant});
  }

  /// Begins the next job and returns it with its tenant. Returns nullopt if no tenant has a job for
  /// this kind of slot.
  std::optional<std::pair<WaitingJob, std::string>> Begin(bool for_interactive) {
    for (auto at = order_.begin(); at != order_.end(); ++at) {
      const std::string tenant = std::get<2>(*at);
      Entry entry = entries_.at(tenant);
      const WaitingJob job = entry.queue->waiting[entry.next];
      if (for_interactive && !job.interactive) continue;
      order_.erase(at);
      ++held_[tenant];
      entry.turn_us = ++last_turn_us_;
      if (++entry.next == entry.queue->waiting.size()) {
        entries_.erase(tenant);
      } else {
        Enter(entry);
      }
      return std::pair(job, tenant);
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    const TenantQueue* queue = nullptr;
    int64_t turn_us = 0;
    size_t next = 0;  ///< index of the next waiting job
  };

  void Enter(const Entry& entry) {
    const std::string& tenant = entry.queue->tenant;
    entries_[tenant] = entry;
    order_.insert({held_[tenant], entry.turn_us, tenant});
  }

  int64_t last_turn_us_;
  std::map<std::string, int64_t> held_;
  std::map<std::string, Entry> entries_;  ///< tenants with waiting jobs
  std::set<std::tuple<int64_t, int64_t, std::string>> order_;
};

}  // namespace

int64_t MeanRunUs(const QueueSnapshot& queue) {
  if (queue.runs_us.size() < kFewestRuns) return 0;
  return std::reduce(queue.runs_us.begin(), queue.runs_us.end()) / std::ssize(queue.runs_us);
}

std::vector<ExpectedRun> ExpectedRuns(const QueueSnapshot& queue, int64_t now_us) {
  const int64_t mean_us = MeanRunUs(queue);
  const int64_t run_us = mean_us > 0 ? mean_us : kAnyRunUs;
  JobSlots slots = SlotsOf(queue, run_us, now_us);
  int64_t rank = std::ssize(slots);
  TenantOrder tenants(queue, now_us);
  std::vector<ExpectedRun> runs;
  while (!tenants.empty() && !slots.empty()) {
    JobSlot slot = slots.top();
    slots.pop();
    if (slot.taken) tenants.Ended(slot.tenant);
    const auto begun = tenants.Begin(slot.for_interactive);
    if (!begun) continue;
    const int64_t start_us = slot.free_us;
    runs.push_back({begun->first.number, start_us, start_us + run_us});
    slots.push({start_us + run_us, rank++, slot.for_interactive, begun->second, true});
  }
  return runs;
}

}  // namespace slicefarm::coordinator
