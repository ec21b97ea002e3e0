#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "common/rpc/json_log.h"
#include "services/coordinator/run/blob_sweep.h"

namespace slicefarm::coordinator {

/// Sweeps the stores at once and from time to time, from a thread of its own.
class Maintenance {
 public:
  struct Options {
    SweepOptions sweep;
    std::chrono::seconds every{600};
  };

  Maintenance(JobStore& jobs, BlobStores& blobs, Options options, std::function<int64_t()> now_us,
              rpc::JsonLog log);
  ~Maintenance();

 private:
  void Run();
  void SweepOnce();

  JobStore& jobs_;
  BlobStores& blobs_;
  const Options options_;
  const std::function<int64_t()> now_us_;
  const rpc::JsonLog log_;
  std::mutex mutex_;
  std::condition_variable stop_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace slicefarm::coordinator
