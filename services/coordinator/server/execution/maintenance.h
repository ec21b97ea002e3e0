#pragma once

#include <chrono>
#include <functional>
#include <thread>

#include "common/rpc/observe/json_log.h"
#include "services/coordinator/run/blob_sweep.h"
#include "services/coordinator/store/jobs/profile_store.h"

namespace slicefarm::coordinator {

/// Sweeps the stores from time to time, from a thread of its own; of the coordinators that share
/// them, one does. Nothing is removed before the store IsSettled.
class Maintenance {
 public:
  struct Options {
    SweepOptions sweep;
    double keep_revisions_s = 90.0 * 24 * 3600;  ///< of profiles: ProfileStore::Expire
    std::chrono::seconds every{600};
  };

  Maintenance(JobStore& jobs, BlobStores& blobs, ProfileStore& profiles, Options options,
              std::function<int64_t()> now_us, rpc::JsonLog log);
  Maintenance(const Maintenance&) = delete;
  Maintenance& operator=(const Maintenance&) = delete;

 private:
  void Run(const std::stop_token& stop);
  void SweepOnce(const std::stop_token& stop);

  JobStore& jobs_;
  BlobStores& blobs_;
  ProfileStore& profiles_;
  const Options options_;
  const std::function<int64_t()> now_us_;
  const rpc::JsonLog log_;
  std::jthread thread_;  ///< the last member: it uses the others
};

}  // namespace slicefarm::coordinator
