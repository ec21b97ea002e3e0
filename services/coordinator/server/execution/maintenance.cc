#include "services/coordinator/server/execution/maintenance.h"

#include <string>
#include <utility>

#include "common/base/stoppable_sleep.h"

namespace slicefarm::coordinator {

Maintenance::Maintenance(JobStore& jobs, BlobStores& blobs, Options options,
                         std::function<int64_t()> now_us, rpc::JsonLog log)
    : jobs_(jobs),
      blobs_(blobs),
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
  const auto swept = Sweep(jobs_, blobs_, options_.sweep, now_us_(), cancel);
  if (!swept.ok()) {
    log_.Warn("sweep failed", {{"error", std::string(swept.status().message())}});
  } else if (swept->jobs + swept->blobs > 0) {
    log_.Info("swept", {{"jobs", swept->jobs}, {"blobs", swept->blobs}, {"bytes", swept->bytes}});
  }
}

}  // namespace slicefarm::coordinator
