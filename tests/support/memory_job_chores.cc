// Maintenance functions of MemoryJobStore, and its usage records.
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator {

absl::StatusOr<bool> MemoryJobStore::TakeChore(const std::string& chore, int64_t now_us,
                                               int64_t until_us) {
  const std::lock_guard lock(jobs_.mutex_);
  int64_t& until = jobs_.chores_[chore];
  const bool free = until <= now_us;
  if (free) until = until_us;
  return free;
}

absl::StatusOr<int64_t> MemoryJobStore::InUseSince(int64_t now_us, int64_t most_gap_us) {
  const std::lock_guard lock(jobs_.mutex_);
  const auto last = jobs_.chores_.find("use_last");
  if (last == jobs_.chores_.end() || now_us - last->second > most_gap_us)
    jobs_.chores_["use_begin"] = now_us;
  jobs_.chores_["use_last"] = now_us;
  return jobs_.chores_["use_begin"];
}

}  // namespace slicefarm::coordinator
