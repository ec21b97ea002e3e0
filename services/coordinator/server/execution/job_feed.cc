#include "services/coordinator/server/execution/job_feed.h"

#include <utility>

namespace slicefarm::coordinator {

int64_t JobFeed::Listen(const std::string& job_id, Listener listener) {
  std::lock_guard lock(mutex_);
  const int64_t ticket = next_ticket_++;
  entries_.emplace(ticket, Entry{job_id, std::move(listener)});
  by_job_.emplace(job_id, ticket);
  return ticket;
}

void JobFeed::Forget(int64_t ticket) {
  std::lock_guard lock(mutex_);
  const auto entry = entries_.find(ticket);
  if (entry == entries_.end()) return;
  const auto [first, last] = by_job_.equal_range(entry->second.job_id);
  for (auto i = first; i != last; ++i) {
    if (i->second != ticket) continue;
    by_job_.erase(i);
    break;
  }
  entries_.erase(entry);
}

void JobFeed::Changed(const std::string& job_id) {
  std::lock_guard lock(mutex_);
  const auto [first, last] = by_job_.equal_range(job_id);
  for (auto i = first; i != last; ++i) entries_.at(i->second).listener();
}

void JobFeed::AllChanged() {
  std::lock_guard lock(mutex_);
  for (const auto& [ticket, entry] : entries_) entry.listener();
}

void JobFeed::Close() {
  closed_ = true;
  AllChanged();
}

}  // namespace slicefarm::coordinator
