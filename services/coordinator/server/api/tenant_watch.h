#pragma once

#include <grpcpp/grpcpp.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

#include "absl/status/status.h"
#include "services/coordinator/server/execution/job_feed.h"
#include "services/coordinator/server/messages/tenant_events.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// Largest number of WatchJobs calls. Each one occupies a thread, which is acceptable because few
/// clients watch all jobs of a tenant.
inline constexpr int kTenantWatches = 32;

/// One WatchJobs call. Sends the events of a tenant's jobs when the feed announces them, until the
/// client leaves or the coordinator stops.
class TenantWatch {
 public:
  using Writer = grpc::ServerWriter<v1::WatchJobsResponse>;

  /// Creates a watch. All arguments must outlive it.
  TenantWatch(JobStore& jobs, JobFeed& feed, const std::function<int64_t()>& now_us);
  ~TenantWatch() { feed_.Forget(ticket_); }
  TenantWatch(const TenantWatch&) = delete;
  TenantWatch& operator=(const TenantWatch&) = delete;

  /// Sends events until an error occurs. Errors: see JobStore::EventsOf; CoordinatorStops;
  /// Cancelled when the client has left.
  absl::Status Run(TenantEvents events, const grpc::ServerContext& context, Writer& writer);

 private:
  absl::Status Send(const TenantEvents& events, const std::vector<TenantEvent>& found,
                    Writer& writer);
  void AwaitNews();

  JobStore& jobs_;
  JobFeed& feed_;
  const std::function<int64_t()>& now_us_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool news_ = true;
  int64_t ticket_ = 0;
};

}  // namespace slicefarm::coordinator
