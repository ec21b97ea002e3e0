#include "services/coordinator/server/api/full_queues.h"

#include <algorithm>

#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kMinPauseUs = 50'000;
constexpr int64_t kMaxPauseUs = 1'000'000;
/// Pause per open job of a tenant. Only a farm that ends more than 200 jobs of a tenant per second
/// could empty the queue during the pause.
constexpr int64_t kPauseAJobUs = 5'000;

}  // namespace

void FullQueues::Note(const std::string& tenant, const absl::Status& created, int64_t max_open) {
  const std::lock_guard lock(mutex_);
  if (created.ok()) refusals_.erase(tenant);
  if (DetailOf(created).reason != Reason::kQueueFull) return;
  const int64_t pause_us =
      std::clamp(max_open, kMinPauseUs / kPauseAJobUs, kMaxPauseUs / kPauseAJobUs) * kPauseAJobUs;
  refusals_[tenant] = {created, now_us_() + pause_us};
}

absl::Status FullQueues::Check(const std::string& tenant) {
  const std::lock_guard lock(mutex_);
  const auto found = refusals_.find(tenant);
  if (found == refusals_.end()) return absl::OkStatus();
  if (now_us_() < found->second.until_us) return found->second.status;
  refusals_.erase(found);
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
