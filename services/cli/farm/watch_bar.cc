#include "services/cli/farm/watch_bar.h"

#include <utility>

#include "services/cli/farm/queue_text.h"
#include "services/cli/farm/server_options.h"

namespace slicefarm::cli {
namespace {

constexpr std::chrono::seconds kAskEvery{2};

}  // namespace

WatchBar::WatchBar(bool wanted, JobsClientOptions client, std::string job_id)
    : options_(std::move(client)), job_id_(std::move(job_id)), bar_(wanted) {
  if (bar_.enabled())
    thread_ = std::jthread([this](const std::stop_token& stop) { AskForPlaces(stop); });
}

void WatchBar::Show(const v1::Job& event) {
  const std::lock_guard lock(mutex_);
  queued_ = event.state() == v1::JOB_STATE_QUEUED;
  ShowProgress(bar_, event);
  changed_.notify_all();
}

void WatchBar::Clear() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  bar_.Clear();
}

void WatchBar::AskForPlaces(const std::stop_token& stop) {
  options_.cancel = CancelToken([stop] { return stop.stop_requested(); });
  JobsClient client(options_);
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested() && changed_.wait(lock, stop, [this] { return queued_; })) {
    lock.unlock();
    const auto job = client.GetJob(job_id_, v1::JOB_VIEW_BASIC);
    const std::string text =
        job.ok() ? QueueText(*job, std::chrono::system_clock::now()) : std::string();
    lock.lock();
    if (queued_ && !text.empty()) bar_.Show(text, 0, 0);
    changed_.wait_for(lock, stop, kAskEvery, [this] { return !queued_; });
  }
}

}  // namespace slicefarm::cli
