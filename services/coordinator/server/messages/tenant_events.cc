#include "services/coordinator/server/messages/tenant_events.h"

#include <algorithm>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kPageOfEvents = 200;

}  // namespace

absl::StatusOr<std::vector<TenantEvent>> TenantEvents::Next(int64_t now_us) {
  EventCursor after;
  bool back = false;
  if (page_) {
    after = *page_;
  } else {
    back = now_us - looked_back_us_ >= kLookBackEveryUs;
    // 1 us is subtracted, so that events with exactly this time are included.
    after.time_us = std::max(from_us_, last_us_ - (back ? kLateUs : kSoonUs)) - 1;
    after.number = after.sequence = INT64_MAX;
  }
  auto found = jobs_.EventsOf(tenant_, after, kPageOfEvents);
  if (!found.ok()) return found;
  if (back) looked_back_us_ = now_us;
  page_.reset();
  if (std::ssize(*found) == kPageOfEvents) page_ = found->back().cursor;
  std::erase_if(*found,
                [&](const TenantEvent& event) { return !reported_.insert(event.cursor).second; });
  for (const TenantEvent& event : *found) last_us_ = std::max(last_us_, event.cursor.time_us);
  if (!page_)
    reported_.erase(reported_.begin(), reported_.lower_bound({last_us_ - kLateUs, -1, -1}));
  return found;
}

std::string TenantEvents::cursor() const {
  return absl::StrCat(std::max(from_us_, last_us_ - kLateUs));
}

std::optional<int64_t> TimeOfCursor(const std::string& cursor) {
  int64_t time_us = 0;
  if (!absl::SimpleAtoi(cursor, &time_us) || time_us < 0) return std::nullopt;
  return time_us;
}

}  // namespace slicefarm::coordinator
