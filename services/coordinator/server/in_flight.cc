#include "services/coordinator/server/in_flight.h"

#include <chrono>

namespace slicefarm::coordinator {
namespace {

constexpr std::chrono::milliseconds kPoll{50};

}  // namespace

bool InFlight::Enter(const std::string& digest, const std::function<bool()>& given_up) {
  std::unique_lock lock(mutex_);
  while (!given_up()) {
    if (digests_.insert(digest).second) return true;
    left_.wait_for(lock, kPoll);
  }
  return false;
}

void InFlight::Leave(const std::string& digest) {
  std::lock_guard lock(mutex_);
  digests_.erase(digest);
  left_.notify_all();
}

}  // namespace slicefarm::coordinator
