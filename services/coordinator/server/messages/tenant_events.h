#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Events of a tenant's jobs in sequence, each exactly once. An event may appear in the store after
/// events with later times: another coordinator has committed them earlier, or its own commit had
/// to wait. So the recent period is read again and again. Not thread-safe.
class TenantEvents {
 public:
  /// Longest allowed delay between the time of an event and its commit. Events that are committed
  /// later are missed. The delay exceeds the longest write plus the difference of the clocks.
  static constexpr int64_t kLateUs = 60'000'000;
  /// Period before the last event that each call reads again. Every kLookBackEveryUs, a call reads
  /// the whole period kLateUs again.
  static constexpr int64_t kSoonUs = 2'000'000;
  static constexpr int64_t kLookBackEveryUs = 5'000'000;

  /// Creates a sequence of events from `from_us` on. `jobs` must outlive it.
  TenantEvents(JobStore& jobs, std::string tenant, int64_t from_us)
      : jobs_(jobs), tenant_(std::move(tenant)), from_us_(from_us), last_us_(from_us) {}

  /// Returns the next page of events that were not returned yet. more() reports whether there is
  /// another page. Errors: see JobStore::EventsOf; after an error, the next call continues at the
  /// same position.
  absl::StatusOr<std::vector<TenantEvent>> Next(int64_t now_us);
  /// Returns true if Next can return another page at once.
  bool more() const { return page_.has_value(); }

  /// Returns the cursor from which a client that has received all events so far can continue. It is
  /// a little earlier than the last event, because earlier events may still appear. The client then
  /// gets some events twice.
  std::string cursor() const;

 private:
  JobStore& jobs_;
  const std::string tenant_;
  const int64_t from_us_;
  int64_t last_us_;                  ///< time of the last event that was returned
  int64_t looked_back_us_ = 0;       ///< time of the last full read of the range with late events
  std::optional<EventCursor> page_;  ///< position where an incomplete read continues
  /// Returned events in the period that is read again; they are not returned twice.
  std::set<EventCursor> reported_;
};

/// Returns the time of a cursor; nullopt if the cursor is invalid.
std::optional<int64_t> TimeOfCursor(const std::string& cursor);

}  // namespace slicefarm::coordinator
