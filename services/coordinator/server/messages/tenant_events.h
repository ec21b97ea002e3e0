#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// The events of a tenant's jobs one after the other, each once. One may be committed later than
/// others of a later time, by another coordinator or after a wait for the store: so what is that
/// young is looked at again and again. Not thread-safe.
class TenantEvents {
 public:
  /// What is committed later than this after its time is missed: longer than any write may take,
  /// together with what clocks may differ by.
  static constexpr int64_t kLateUs = 60'000'000;
  /// The last moments are looked at by each call; all that may be late, once in a while.
  static constexpr int64_t kSoonUs = 2'000'000;
  static constexpr int64_t kLookBackEveryUs = 5'000'000;

  /// `jobs` outlives it.
  TenantEvents(JobStore& jobs, std::string tenant, int64_t from_us)
      : jobs_(jobs), tenant_(std::move(tenant)), from_us_(from_us), last_us_(from_us) {}

  /// Those that were not told yet; a page of them, more() says whether there are others. Errors:
  /// the store's, after which it goes on where it was.
  absl::StatusOr<std::vector<TenantEvent>> Next(int64_t now_us);
  bool more() const { return page_.has_value(); }

  /// Where somebody can begin who has all that was told: a little before, as for what is late.
  std::string cursor() const;

 private:
  JobStore& jobs_;
  const std::string tenant_;
  const int64_t from_us_;
  int64_t last_us_;                 ///< of what was told
  int64_t looked_back_us_ = 0;      ///< when all was looked at that may be late
  std::optional<EventPlace> page_;  ///< where the look goes on that is not at its end
  std::set<EventPlace> told_;       ///< those that may be found again
};

/// Of a cursor; none: it is none.
std::optional<int64_t> TimeOfCursor(const std::string& cursor);

}  // namespace slicefarm::coordinator
