#include "services/coordinator/server/execution/maintenance.h"

#include <string>
#include <utility>

#include "common/base/cancel_scope.h"
#include "common/base/stoppable_sleep.h"

namespace slicefarm::coordinator {
Maintenance::Maintenance(JobStore& jobs, BlobStores& blobs, ProfileStore& profiles,
                         ProfileStore& preset_bundles, Options options,
                         std::function<int64_t()> now_us, rpc::JsonLog log)
    : jobs_(jobs),
      blobs_(blobs),
      profiles_(profiles),
      preset_bundles_(preset_bundles),
      options_(options),
      now_us_(std::move(now_us)),
      log_(std::move(log)),
      thread_([this](const std::stop_token& stop) { Run(stop); }) {}

void Maintenance::Run(const std::stop_token& stop) {
  do {
    SweepOnce(stop);
  } while (SleepUnlessStopped(stop, options_.every));
}

void Maintenance::SweepOnce(const std::stop_token& stop) {
  const CancelToken cancel([&] { return stop.stop_requested(); });
  const CancelScope scope(cancel);
  // The turn is shorter than the sweep interval, so that the same coordinator may take the next
  // turn.
  const auto turn_us = std::chrono::microseconds(options_.every).count() * 9 / 10;
  const auto mine = jobs_.TakeChore("sweep", now_us_(), now_us_() + turn_us);
  if (!mine.ok()) log_.Warn("sweep failed", {{"error", std::string(mine.status().message())}});
  if (!mine.ok() || !*mine) return;
  const auto in_use = HasBeenInUse(jobs_, options_.sweep, now_us_());
  if (!in_use.ok()) log_.Warn("sweep failed", {{"error", std::string(in_use.status().message())}});
  if (!in_use.ok() || !*in_use) return;
  const auto swept = Sweep(jobs_, blobs_, options_.sweep, now_us_(), cancel);
  if (!swept.ok()) {
    log_.Warn("sweep failed", {{"error", std::string(swept.status().message())}});
  } else if (swept->jobs + swept->blobs > 0) {
    log_.Info("swept", {{"jobs", swept->jobs}, {"blobs", swept->blobs}, {"bytes", swept->bytes}});
  }
  const auto kept_us = static_cast<int64_t>(options_.keep_revisions_s * 1e6);
  for (ProfileStore* store : {&profiles_, &preset_bundles_}) {
    const auto expired = store->Expire(now_us_() - kept_us);
    if (!expired.ok())
      log_.Warn("profiles not swept", {{"error", std::string(expired.status().message())}});
  }
}

}  // namespace slicefarm::coordinator
