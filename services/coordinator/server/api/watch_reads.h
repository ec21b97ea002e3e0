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

/// Job with some of its events.
struct JobSteps {
  JobRecord job;  ///< read after the events, so it may be newer; without its spec
  std::vector<JobEventRecord> events;  ///< events in sequence

  /// Returns true if the job has ended and has no event after `sequence`.
  bool EndsAt(int64_t sequence) const {
    return IsTerminal(job.state) && sequence >= job.last_sequence;
  }
};

/// Returns the error UNAVAILABLE, with the time after which another coordinator, or this one after
/// its restart, can be called.
absl::Status CoordinatorStops();

/// Reads events for watchers, on its own threads. All watchers that need the same events of a job
/// share one read. Tenants take turns. Thread-safe.
class WatchReads {
 public:
  using Result = absl::StatusOr<std::shared_ptr<const JobSteps>>;
  /// Function that receives the result. It is called once, from any thread, and must be quick.
  using Done = std::function<void(Result result)>;

  /// Starts the threads. `jobs` must outlive this object. REQUIRES: threads >= 1.
  WatchReads(JobStore& jobs, int threads);
  ~WatchReads() { Stop(); }
  WatchReads(const WatchReads&) = delete;
  WatchReads& operator=(const WatchReads&) = delete;

  static constexpr int32_t kEventsAtOnce = 100;

  /// Reads at most kEventsAtOnce events of the job after `sequence`, and passes the result to
  /// `done`. The result is not older than this call. Errors: see JobStore::Events; JOB_NOT_FOUND
  /// also for an unreadable record of another tenant's job; CoordinatorStops.
  void Read(const std::string& tenant, const std::string& job_id, int64_t sequence, Done done);

  /// Ends the reads. After the return, all earlier requests have received a result, and new
  /// requests get CoordinatorStops at once.
  void Stop();

 private:
  struct Wanted {
    std::string job_id;
    int64_t sequence = 0;

    friend auto operator<=>(const Wanted&, const Wanted&) = default;
  };
  struct Tenant {
    std::deque<Wanted> queue;
    std::map<Wanted, std::vector<Done>> waiting;  ///< callers that wait for each read in `queue`
  };

  void Run();
  Result ReadNow(const std::string& tenant, const Wanted& wanted);

  JobStore& jobs_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false;
  std::map<std::string, Tenant> tenants_;  ///< tenants with waiting reads
  /// Tenants with waiting reads, in the order of their turns.
  std::deque<std::string> turns_;
  std::vector<std::thread> threads_;
};

}  // namespace slicefarm::coordinator
