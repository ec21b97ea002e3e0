#include "services/coordinator/server/api/derived_facts.h"

#include <chrono>
#include <optional>

#include "common/base/sha256.h"

namespace slicefarm::coordinator {

absl::StatusOr<DerivedFacts::Fact> DerivedFacts::Of(const std::string& key,
                                                    const CancelToken& cancel, const Make& make) {
  constexpr std::chrono::milliseconds kAskToken{50};
  std::unique_lock lock(mutex_);
  while (true) {
    if (const auto found = kept_.find(key); found != kept_.end()) return found->second;
    if (being_made_.insert(key).second) break;
    made_.wait_for(lock, kAskToken);
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
  }
  lock.unlock();
  const absl::StatusOr<std::string> text = make();
  const absl::StatusOr<Fact> fact =
      text.ok() ? absl::StatusOr<Fact>(Fact{std::ssize(*text), Sha256Hex(*text)}) : text.status();
  lock.lock();
  being_made_.erase(key);
  if (kept_.size() >= kMostKept) kept_.clear();
  if (fact.ok() || absl::IsNotFound(fact.status())) kept_.emplace(key, fact);
  made_.notify_all();
  return fact;
}

}  // namespace slicefarm::coordinator
