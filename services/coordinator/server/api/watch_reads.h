#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Where a job stands.
struct JobSteps {
  JobRecord job;                       ///< without its spec
  std::vector<JobEventRecord> events;  ///< read before the job, which may have gone on since

  /// Whether nothing comes after `sequence`.
  bool EndsAt(int64_t sequence) const {
    return IsTerminal(job.state) && sequence >= job.last_sequence;
  }
};

/// UNAVAILABLE, with the time after which another coordinator, or the next life of this one, can be
/// asked.
absl::Status CoordinatorStops();

/// Reads for those who watch jobs, on threads of its own. All who want the same of a job get it
/// from one read; tenants take turns. Thread-safe.
class WatchReads {
 public:
  using Result = absl::StatusOr<std::shared_ptr<const JobSteps>>;
  /// Is called once, from any thread; must be quick.
  using Done = std::function<void(Result result)>;

  /// `jobs` outlives it. REQUIRES: threads >= 1.
  WatchReads(JobStore& jobs, int threads);
  ~WatchReads() { Stop(); }
  WatchReads(const WatchReads&) = delete;
  WatchReads& operator=(const WatchReads&) = delete;

  static constexpr int32_t kEventsAtOnce = 100;

  /// Events of the job after `sequence`, kEventsAtOnce at most, as they are when this is called or
  /// later. Errors: those of JobStore::Events; JOB_NOT_FOUND also for another tenant's job that
  /// cannot be read; CoordinatorStops.
  void Read(const std::string& tenant, const std::string& job_id, int64_t sequence, Done done);

  /// Afterwards all who asked have their answers, and who asks hears CoordinatorStops at once.
  void Stop();

 private:
  struct Wanted {
    std::string job_id;
    int64_t sequence = 0;

    friend auto operator<=>(const Wanted&, const Wanted&) = default;
  };
  struct Tenant {
    std::deque<Wanted> queue;
    std::map<Wanted, std::vector<Done>> waiting;  ///< those of the queue
  };

  void Run();
  Result ReadNow(const std::string& tenant, const Wanted& wanted);

  JobStore& jobs_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false;
  std::map<std::string, Tenant> tenants_;  ///< who want something
  std::deque<std::string> turns_;          ///< the same, in the order of their turns
  std::vector<std::thread> threads_;
};

}  // namespace slicefarm::coordinator
