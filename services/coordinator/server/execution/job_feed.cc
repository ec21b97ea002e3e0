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

void JobFeed::Notify(const std::string& job_id, News news) {
  const auto [first, last] = by_job_.equal_range(job_id);
  for (auto i = first; i != last; ++i) entries_.at(i->second).listener(news);
}

void JobFeed::Changed(const std::string& job_id) {
  std::lock_guard lock(mutex_);
  Notify(job_id, News::kEvents);
  if (!job_id.empty()) Notify("", News::kEvents);  // for listeners to all jobs
}

void JobFeed::Progressed(const std::string& job_id, const JobProgress& progress) {
  std::lock_guard lock(mutex_);
  running_[job_id] = progress;
  Notify(job_id, News::kProgress);
}

void JobFeed::Ended(const std::string& job_id, int64_t epoch) {
  std::lock_guard lock(mutex_);
  const auto found = running_.find(job_id);
  if (found != running_.end() && found->second.epoch <= epoch) running_.erase(found);
}

void JobFeed::Progressed(ProgressReport report) {
  std::lock_guard lock(mutex_);
  ProgressReport& reported = elsewhere_[report.owner];
  const ProgressReport before = std::exchange(reported, std::move(report));
  for (const auto& [id, progress] : reported.jobs) {
    const auto then = before.jobs.find(id);
    if (then == before.jobs.end() || then->second != progress) Notify(id, News::kProgress);
  }
}

std::map<std::string, JobProgress> JobFeed::Running() const {
  std::lock_guard lock(mutex_);
  return running_;
}

std::optional<JobProgress> JobFeed::ProgressOf(const std::string& job_id) const {
  std::lock_guard lock(mutex_);
  std::optional<JobProgress> latest;
  const auto look = [&](const std::map<std::string, JobProgress>& jobs) {
    const auto found = jobs.find(job_id);
    if (found != jobs.end() && (!latest || latest->epoch < found->second.epoch))
      latest = found->second;
  };
  look(running_);
  for (const auto& [owner, report] : elsewhere_) look(report.jobs);
  return latest;
}

void JobFeed::AddProgress(JobRecord& job) const {
  if (job.state != JobState::kRunning) return;
  const auto progress = ProgressOf(job.id);
  if (!progress || progress->epoch != job.owner_epoch) return;
  job.layers_total = progress->layers_total;
  job.layers_done = progress->layers_done;
}

void JobFeed::AllChanged() {
  std::lock_guard lock(mutex_);
  for (const auto& [ticket, entry] : entries_) entry.listener(News::kEvents);
}

void JobFeed::Close() {
  closed_ = true;
  AllChanged();
}

}  // namespace slicefarm::coordinator
