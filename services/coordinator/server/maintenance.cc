#include "services/coordinator/server/maintenance.h"

#include <string>
#include <utility>

namespace slicefarm::coordinator {

Maintenance::Maintenance(JobStore& jobs, BlobStores& blobs, Options options,
                         std::function<int64_t()> now_us, rpc::JsonLog log)
    : jobs_(jobs),
      blobs_(blobs),
      options_(options),
      now_us_(std::move(now_us)),
      log_(std::move(log)),
      thread_([this] { Run(); }) {}

Maintenance::~Maintenance() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  stop_.notify_all();
  thread_.join();
}

void Maintenance::Run() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    SweepOnce();
    lock.lock();
    stop_.wait_for(lock, options_.every, [this] { return stopping_; });
  }
}

void Maintenance::SweepOnce() {
  const CancelToken cancel([this] {
    const std::lock_guard lock(mutex_);
    return stopping_;
  });
  const auto swept = Sweep(jobs_, blobs_, options_.sweep, now_us_(), cancel);
  if (!swept.ok()) {
    log_.Warn("sweep failed", {{"error", std::string(swept.status().message())}});
  } else if (swept->jobs + swept->blobs > 0) {
    log_.Info("swept", {{"jobs", swept->jobs}, {"blobs", swept->blobs}, {"bytes", swept->bytes}});
  }
}

}  // namespace slicefarm::coordinator
