#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include "common/rpc/observe/json_log.h"
#include "services/coordinator/run/blob_sweep.h"
#include "services/coordinator/store/jobs/profile_store.h"

namespace slicefarm::coordinator {

/// Sweeps the stores at regular intervals, on its own thread. Of all coordinators that share the
/// stores, only one sweeps. Removes nothing before HasBeenInUse (blob_sweep.h) returns true.
class Maintenance {
 public:
  /// Storage times and the interval of the sweeps.
  struct Options {
    SweepOptions sweep;
    /// Storage time of revisions of profiles and of preset bundles (ProfileStore::Expire).
    double keep_revisions_s = 90.0 * 24 * 3600;
    std::chrono::seconds every{600};
  };

  Maintenance(JobStore& jobs, BlobStores& blobs, ProfileStore& profiles,
              ProfileStore& preset_bundles, Options options, std::function<int64_t()> now_us,
              rpc::JsonLog log);
  Maintenance(const Maintenance&) = delete;
  Maintenance& operator=(const Maintenance&) = delete;

 private:
  void Run(const std::stop_token& stop);
  void SweepOnce(const std::stop_token& stop);

  JobStore& jobs_;
  BlobStores& blobs_;
  ProfileStore& profiles_;
  ProfileStore& preset_bundles_;
  const Options options_;
  const std::function<int64_t()> now_us_;
  const rpc::JsonLog log_;
  std::jthread thread_;  ///< last member, because the thread uses the other members
};

}  // namespace slicefarm::coordinator
